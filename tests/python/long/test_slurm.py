"""The array job of Slurm, on a Slurm of one node that this test starts with its own configuration."""

import os
import pwd
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pygirth
import pytest
from pygirth import collection
from pygirth.collection._tasks import _key_of
from shapes import as_obj, torus

CONFIGURATION = """\
ClusterName=girth
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/none
CredType=cred/none
AuthInfo=cred_expire=5
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
MpiDefault=none
MailProg=/bin/true
ReturnToService=2
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


@pytest.fixture
def slurm(tmp_path):
    """Runs Slurm's commands; where it cannot be started, its log is what the failure states."""
    for name in ("state", "spool"):
        (tmp_path / name).mkdir()
    host = socket.gethostname().split(".")[0]
    user = pwd.getpwuid(os.getuid()).pw_name
    text = CONFIGURATION.format(host=host, ports=free_ports(2), user=user, folder=tmp_path)
    (tmp_path / "slurm.conf").write_text(text)
    (tmp_path / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")
    environment = {**os.environ, "SLURM_CONF": str(tmp_path / "slurm.conf"), "PYTHON": sys.executable}
    log = (tmp_path / "daemons.log").open("wb")
    daemons = [
        subprocess.Popen([program, "-D", *options], env=environment, stdout=log, stderr=log)
        for program, *options in (["/usr/sbin/slurmctld", "-c"], ["/usr/sbin/slurmd", "-N", host])
    ]

    def run(*words, check=True):
        done = subprocess.run(words, env=environment, cwd=tmp_path, capture_output=True, text=True)
        assert not check or done.returncode == 0, done.stderr + (tmp_path / "daemons.log").read_text()
        return done.stdout.strip()

    try:
        until(lambda: "idle" in run("sinfo", "-h", "-o", "%t", check=False), tmp_path)
        yield run
    finally:
        for daemon in daemons[::-1]:
            daemon.terminate()
        for daemon in daemons:
            daemon.wait(60)


def until(holds, folder):
    """Waits, as long as it takes within five minutes."""
    end = time.monotonic() + 300
    while not holds():
        assert time.monotonic() < end, (folder / "daemons.log").read_text()[-4000:]
        time.sleep(0.2)


def test_a_job_that_is_killed_is_queued_again_and_goes_on(slurm, tmp_path, repository):
    paths = [tmp_path / f"{i:03}.obj" for i in range(120)]
    for i, path in enumerate(paths):
        path.write_text(as_obj(*torus(40, 16, 3 + i / 50)))
    listed = tmp_path / "list.txt"
    listed.write_text("".join(f"{path}\n" for path in paths))
    script = repository / "cpp/python/examples/fields.sbatch"
    store = tmp_path / "store"
    options = ("--faces", "0", "--save-every", "0")
    job = slurm("sbatch", "--parsable", "--array=1-3", script, listed, store, *options)

    def programs():
        """The Python programs of the job, by their task."""
        found = {}
        for entry in Path("/proc").glob("[0-9]*"):
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if b"pygirth.collection" in words and os.fsencode(store) in words:
                found[words[words.index(b"--part") + 1].decode()] = int(entry.name)
        return found

    # The first task is killed, as for want of memory, when it has written something.
    own = {_key_of(pygirth.load(path)) for path in paths[::3]}

    def written():
        keys = [np.load(path)["keys"].astype("U").tolist() for path in store.rglob("*.npz")]
        return own & {key for some in keys for key in some}

    until(written, tmp_path)
    os.kill(programs()["1/3"], signal.SIGKILL)
    until(lambda: slurm("squeue", "-h", "-j", job, check=False) == "", tmp_path)

    text = (tmp_path / f"slurm-{job}_1.out").read_text()
    assert "ended with code 137: back into the queue" in text
    assert "40 models:" in text and " 0 failed" in text
    models = collection.fields(paths, store=store, faces=0)
    assert (models.computed, models.reused) == (0, 120)
    assert np.array_equal(models.distances(), pygirth.compare(paths, ["igf"], faces=0)["igf"])
    # The second run found the values that the first one had written.
    found = [int(part.split(" found")[0]) for part in text.split("computed, ")[1:]]
    assert len(found) == 1 and 0 < found[0] < 40
