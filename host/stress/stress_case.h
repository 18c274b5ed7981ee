// One row of the table of stress cases: a small scene that is stiff or extreme, and what must come out.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cl/device.h"
#include "options/render_result.h"

namespace pencil {

/// A number that must lie between two others.
struct Measurement {
    std::string what;  // "mean over truth"
    double value = 0, low = 0, high = 0;
    bool holds() const { return value >= low && value <= high; }  // not if it is no number
};

/// Value and the truth, to within a share of the truth.
Measurement near(const std::string& what, double value, double truth, double relative);
/// At most.
Measurement below(const std::string& what, double value, double most);

/// What a case is run with.
struct StressRun {
    std::shared_ptr<Device> device;
    Progress progress;  // may stop it
};

struct StressCase {
    std::string name;   // "furnace-0.9999": unique, of letters, digits, dots and dashes
    std::string scene;  // in words, with what is done to it
    std::function<std::vector<Measurement>(const StressRun&)> run;
    bool quick = true;  // part of the default run and of the tests: a second or two
};

}  // namespace pencil
