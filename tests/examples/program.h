// Runs one of the programs as a shell would, and keeps what it said.
#pragma once

#include "io/scratch.h"
#include "support/check.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace tests {

struct Outcome
{
    int status; // -1 when a signal ended it
    std::string output, errors;
};

using Environment = std::vector<std::pair<std::string, std::string>>; // added to that of the test

inline Outcome run(const std::string& program, const std::vector<std::string>& arguments,
                   const Environment& environment = {})
{
    const Scratch said;
    const std::string outputFile = said / "output", errorsFile = said / "errors";
    std::vector<char*> words = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const pid_t child = fork();
    CHECK(child >= 0);
    if (child == 0) {
        for (const auto& [name, value] : environment)
            setenv(name.c_str(), value.c_str(), 1);
        constexpr int flags = O_CREAT | O_WRONLY;
        dup2(open(outputFile.c_str(), flags, 0600), STDOUT_FILENO);
        dup2(open(errorsFile.c_str(), flags, 0600), STDERR_FILENO);
        execv(program.c_str(), words.data());
        _exit(127);
    }
    int how = 0;
    CHECK(waitpid(child, &how, 0) == child);
    return {WIFEXITED(how) ? WEXITSTATUS(how) : -1, bytesOf(outputFile), bytesOf(errorsFile)};
}

// Runs it and expects success; what it says on stderr is printed when it fails.
inline void runWell(const std::string& program, const std::vector<std::string>& arguments)
{
    const Outcome outcome = run(program, arguments);
    if (outcome.status != 0)
        std::fprintf(stderr, "%s", outcome.errors.c_str());
    CHECK(outcome.status == 0);
}

} // namespace tests
