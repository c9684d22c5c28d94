"""Work shared out: to threads of this process, to an executor, or to the workers of Dask."""

from __future__ import annotations

import os
import threading
from collections import deque
from concurrent.futures import FIRST_COMPLETED, Executor, ThreadPoolExecutor, wait
from typing import Any, Callable, Iterator, Optional

from pygirth.errors import input_error

#: Tasks that are with the scheduler at a time: enough for a few hundred workers.
WINDOW = 1000

Task = tuple[Any, ...]
#: The arguments of a task, its result, and what it has raised instead.
Done = tuple[Task, Any, Optional[BaseException]]


def cores() -> int:
    """The cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class _Stopped(BaseException):
    """Stops a task in a thread of this process, where nobody waits for it any more; no error of a model."""


#: `stop`: an event of the work that the task of this thread belongs to.
_here = threading.local()


def until_stopped(_: float) -> None:
    """Progress of a task: raises where nobody waits for its result any more."""
    stop = getattr(_here, "stop", None)
    if stop is not None and stop.is_set():
        raise _Stopped


def _in_thread(stop: threading.Event, function: Callable[..., Any], task: Task) -> Any:
    _here.stop = stop
    try:
        return function(*task)
    finally:
        _here.stop = None


class Work:
    """Calls of one function whose results come as they are finished; more can be added meanwhile.

    What is still to be done when the iteration is left is cancelled, and what threads of this process are at is stopped.
    """

    def __init__(self, client: Any, function: Callable[..., Any]) -> None:
        self._client = client
        self._function = function
        self._tasks: deque[Task] = deque()

    def add(self, *arguments: Any) -> None:
        """Adds a call."""
        self._tasks.append(arguments)

    def __iter__(self) -> Iterator[Done]:
        if self._client is None:
            with ThreadPoolExecutor(cores()) as pool:
                yield from self._by_executor(pool)
        elif _is_dask(self._client):
            yield from self._by_dask(self._client)
        elif isinstance(self._client, Executor):
            yield from self._by_executor(self._client)
        else:
            raise input_error(
                "INVALID_OPTION",
                f"a {type(self._client).__name__} is no client",
                "pass a dask.distributed.Client, an executor of concurrent.futures, or None",
            )

    def _by_executor(self, executor: Executor) -> Iterator[Done]:
        running: dict[Any, Task] = {}
        stop = threading.Event()

        def submit(task: Task) -> Any:
            if isinstance(executor, ThreadPoolExecutor):
                return executor.submit(_in_thread, stop, self._function, task)
            return executor.submit(self._function, *task)

        try:
            while self._tasks or running:
                while self._tasks and len(running) < WINDOW:
                    task = self._tasks.popleft()
                    running[submit(task)] = task
                for future in wait(running, return_when=FIRST_COMPLETED).done:
                    task = running.pop(future)
                    error = future.exception()
                    yield task, None if error else future.result(), error
        finally:
            stop.set()
            for future in running:
                future.cancel()

    def _by_dask(self, client: Any) -> Iterator[Done]:
        from distributed import as_completed

        # Results are fetched as soon as they are there: a worker that dies later takes none with it.
        done = as_completed(with_results=True, raise_errors=False)
        running: dict[str, tuple[Any, Task]] = {}

        def submit() -> None:
            while self._tasks and len(running) < WINDOW:
                task = self._tasks.popleft()
                future = client.submit(self._function, *task, pure=False)
                running[future.key] = (future, task)
                done.add(future)

        try:
            submit()
            while running:
                future, result = next(done)
                _, task = running.pop(future.key)
                error = future.exception() if future.status == "error" else None
                # Let go of before more is added, so that the scheduler's memory stays bounded.
                future.release()
                yield task, None if error else result, error
                submit()
        finally:
            client.cancel([future for future, _ in running.values()])


def _is_dask(client: Any) -> bool:
    return type(client).__module__.split(".")[0] == "distributed" and hasattr(client, "scatter")
