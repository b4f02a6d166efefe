// map_tool as a shell sees it: what it prints, its exit status, one line on stderr and nothing half done.
#include "support/check.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

namespace {

struct Outcome
{
    int status;
    std::string output;
    std::string complaint;
};

std::string textOf(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

Outcome run(const std::string& arguments, const std::string& input = "")
{
    const std::string scratch = SCRATCH_FOLDER "/map_tool_";
    std::ofstream(scratch + "in") << input;
    const std::string command = "'" MAP_TOOL "' " + arguments + " < '" + scratch + "in' > '" + scratch +
                                "out' 2> '" + scratch + "err'";
    const int status = std::system(command.c_str());
    CHECK(WIFEXITED(status));
    return {WEXITSTATUS(status), textOf(scratch + "out"), textOf(scratch + "err")};
}

void checkPrints(const std::string& arguments, const std::string& input, const std::string& expected)
{
    const Outcome outcome = run(arguments, input);
    if (outcome.output != expected)
        std::fprintf(stderr, "%s printed:\n%s%s", arguments.c_str(), outcome.output.c_str(),
                     outcome.complaint.c_str());
    CHECK(outcome.status == 0 && outcome.output == expected && outcome.complaint.empty());
}

// Nothing on stdout, one line on stderr, with the words that matter.
void checkRefuses(int status, const std::string& arguments, const std::string& mentions,
                  const std::string& input = "")
{
    const Outcome outcome = run(arguments, input);
    if (outcome.status != status || outcome.complaint.find(mentions) == std::string::npos)
        std::fprintf(stderr, "%s: status %d, %s", arguments.c_str(), outcome.status,
                     outcome.complaint.c_str());
    CHECK(outcome.status == status);
    CHECK(outcome.output.empty());
    CHECK(outcome.complaint.find(mentions) != std::string::npos);
    CHECK(outcome.complaint.find('\n') == outcome.complaint.size() - 1);
}

void checkForwardAndInverse()
{
    checkPrints("forward --map cube", "-4 3 -1\n", "1 0.375 0.125\n");
    checkPrints("forward --map cube --precision double", "-0x1p2 3e0 -1", "1 0.375 0.125\n");
    checkPrints("forward --map cube", "inf 1 -1\n\n  0 nan 0\r\n", "0 0.5 0.5\n0 0.5 0.5\n");
    checkPrints("forward --map octahedral", "1 2 5\n", "0 0.5625 0.625\n");
    checkPrints("forward --map octahedral --precision double", "1 1 1\n",
                "0 0.66666666666666663 0.66666666666666663\n");
    checkPrints("inverse --map dual-paraboloid", "1 0.5 0.5\n0 1 0.5\n", "0 0 1\n1 0 -0\n");
    checkPrints("forward", "", "");
}

void checkGlsl()
{
    const Outcome outcome = run("glsl --map tennis-ball --prefix room_ --version 300es");
    CHECK(outcome.status == 0);
    CHECK(outcome.output.find("highp vec3 room_coordinateFromDirection(highp vec3 direction)") !=
          std::string::npos);
    CHECK(run("glsl --map cube").output.find("mirrorball_componentOf") != std::string::npos);
}

void checkMeasure()
{
    const Outcome all = run("measure --map all --texels 393216");
    CHECK(all.status == 0);
    for (const char* const row :
         {"tennis-ball-even", " 2x256x768 ", "0.4824", "0.4972", "0.5729", "0.6330", "octahedral"})
        CHECK(all.output.find(row) != std::string::npos);
    const Outcome one = run("measure --map cube --size 4");
    CHECK(one.status == 0 && one.output.find("6x4x4") != std::string::npos);
    CHECK(one.output.find("octahedral") == std::string::npos);
}

void checkRefusals()
{
    checkRefuses(2, "forward --map cubic", "cubic");
    checkRefuses(2, "forward --precision half", "half");
    checkRefuses(2, "forward --colour red", "--colour");
    checkRefuses(2, "glsl --version 120", "120");
    checkRefuses(2, "measure --size many", "many");
    checkRefuses(2, "measure --size 99999999999", "99999999999");
    checkRefuses(2, "convert a.png --to cube -o b", "convert");
    checkRefuses(2, "", "ubcommand");
    checkRefuses(2, "backward --map cube", "backward");
    checkRefuses(1, "measure --size 0", "--size 0");
    checkRefuses(1, "measure --size -3", "--size -3");
    checkRefuses(1, "measure --size 2000000000", "--size");
    checkRefuses(1, "measure --texels nan", "--texels");
    checkRefuses(1, "measure --texels 0", "--texels");
    checkRefuses(1, "glsl --prefix gl_", "gl_");
    checkRefuses(1, "forward", "line 2", "1 2 3\n1 2\n4 5 6\n");
    checkRefuses(1, "forward", "line 1", "1 2 three\n");
    checkRefuses(1, "forward", "line 1", "1 2 3 4\n");
    checkRefuses(1, "inverse --map cube", "line 1", "6 0.5 0.5\n");
    checkRefuses(1, "inverse --map cube", "line 1", "0.5 0.5 0.5\n");
    checkRefuses(1, "inverse --map cube", "line 1", "-1 0.5 0.5\n");
}

} // namespace

int main()
{
    checkForwardAndInverse();
    checkGlsl();
    checkMeasure();
    checkRefusals();
    for (const char* const verb : {"", "forward", "inverse", "glsl", "measure"})
        CHECK(run(std::string(verb) + " --help").status == 0);
}
