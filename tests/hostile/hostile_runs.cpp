// Rows 36, 37 and 40: command lines, checkpoints and environments. What needs more than one run stands in tests/cli.
#include <algorithm>

#include "hostile/hostile_case.h"

namespace pencil_test {
namespace {

/// A render of the small scene with these options more.
HostileCase render(const std::string& name, int code, const std::string& says, const Arguments& more,
                   const std::map<std::string, std::string>& environment = {}) {
    return {name, code, says,
            [=](const Folder& folder) {
                Arguments arguments{"render", folder.write("scene.xml", small_scene()), "--quiet"};
                for (const Arguments& options : {quick(), more}) arguments.insert(arguments.end(), options.begin(), options.end());
                if (std::find(more.begin(), more.end(), "-o") == more.end()) {
                    arguments.emplace_back("-o");
                    arguments.push_back((folder / "a.exr").string());
                }
                return arguments;
            },
            environment};
}

/// A render that is to go on from these bytes.
HostileCase resume(const std::string& name, const std::string& bytes) {
    return {name, 2, "--resume",
            [=](const Folder& folder) {
                return Arguments{"render",   folder.write("scene.xml", small_scene()),
                                 "-o",       (folder / "a.exr").string(),
                                 "--resume", folder.write("state", bytes)};
            }};
}

}  // namespace

std::vector<HostileCase> hostile_runs() {
    return {
        render("36-option-twice", 2, "--pencils", {"--pencils", "8"}),
        render("36-option-unknown", 2, "--fast", {"--fast"}),
        render("36-rays-1e99", 2, "--light-samples", {"--light-samples", "1e99"}),
        render("36-output-nowhere", 6, "does not exist", {"-o", "/none/a.exr"}),
        render("36-output-read-only", 6, "/proc/a.exr", {"-o", "/proc/a.exr"}),
        render("36-image-of-1e12-pixels", 5, "TiB", {"--resolution", "1000000x1000000"}),
        resume("37-checkpoint-empty", ""),
        resume("37-checkpoint-text", "hello"),
        resume("37-checkpoint-of-zeros", std::string(100000, '\0')),
        render("40-no-platform", 4, "OCL_ICD_VENDORS", {}, {{"OCL_ICD_VENDORS", "/none/"}}),
        render("40-no-device", 4, "POCL_DEVICES", {}, {{"POCL_DEVICES", "bogus"}}),
        render("40-strange-locale", 0, "", {}, {{"LC_ALL", "xx_YY.none"}, {"TZ", "::::"}}),
        render("40-strange-fault", 2, "PENCIL_FAULT", {}, {{"PENCIL_FAULT", "sunspots"}}),
    };
}

}  // namespace pencil_test
