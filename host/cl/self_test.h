// Known answers on the device: drivers and compilers do go wrong, and a wrong picture does not say so.
#pragma once

#include <string>
#include <vector>

#include "cl/program.h"

namespace pencil {

struct SelfTestResult {
    std::string name;
    bool passed = false;
    std::string detail;  // what was wrong, or what was found out
};

/// Runs every check; a check that cannot run (build failure, lost device) is a failed result, not an exception. Takes about a second
/// the first time, milliseconds when the driver has the programs in its cache.
std::vector<SelfTestResult> self_test(ProgramCache& programs);

}  // namespace pencil
