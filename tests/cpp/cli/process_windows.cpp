#include <windows.h>

#include "process.h"

namespace girth::test {
namespace {

/// A word as programs take it out of their command line again.
std::wstring wordOf(const std::string& text) {
  std::wstring word = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : std::filesystem::path(text).wstring()) {
    // Before a quote, backslashes stand for half as many.
    if (c == L'"') word.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    word += c;
  }
  word.append(backslashes, L'\\');
  return word + L"\"";
}

HANDLE newFile(const std::filesystem::path& path) {
  SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
  return CreateFileW(path.c_str(), GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited,
                     CREATE_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
}

}  // namespace

Process startProcess(const std::string& program, const std::vector<std::string>& arguments,
                     const std::filesystem::path& folder) {
  std::wstring line = wordOf(program);
  for (const std::string& argument : arguments) line += L" " + wordOf(argument);
  STARTUPINFOW streams{};
  streams.cb = sizeof(streams);
  streams.dwFlags = STARTF_USESTDHANDLES;
  streams.hStdInput = GetStdHandle(STD_INPUT_HANDLE);
  streams.hStdOutput = newFile(folder / "stdout");
  streams.hStdError = newFile(folder / "stderr");
  PROCESS_INFORMATION made{};
  CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE, CREATE_NEW_PROCESS_GROUP, nullptr,
                 nullptr, &streams, &made);
  CloseHandle(streams.hStdOutput);
  CloseHandle(streams.hStdError);
  CloseHandle(made.hThread);
  return {made.hProcess, made.dwProcessId};
}

void waitUntilInterruptible(const Process&) { Sleep(500); }

bool interrupt(const Process& process) {
  return GenerateConsoleCtrlEvent(CTRL_BREAK_EVENT, process.number) != 0;
}

bool terminate(const Process& process) { return interrupt(process); }

int endOf(const Process& process) {
  DWORD exitCode = 127;
  WaitForSingleObject(process.handle, INFINITE);
  GetExitCodeProcess(process.handle, &exitCode);
  CloseHandle(process.handle);
  return static_cast<int>(exitCode);
}

}  // namespace girth::test
