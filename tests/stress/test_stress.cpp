// Every quick row of the table of stress cases is a test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>

#include "stress/run_stress.h"
#include "stress/stress_cases.h"

namespace pencil {

/// What the runner prints of a row; else it would be its bytes.
void PrintTo(const StressCase& row, std::ostream* out) { *out << row.name; }

}  // namespace pencil

namespace {

using namespace pencil;

std::shared_ptr<Device> device() {
    const char* selector = std::getenv("PENCIL_DEVICE");
    static const std::shared_ptr<Device> opened = Device::open(selector != nullptr ? selector : "");
    return opened;
}

std::vector<StressCase> quick_cases() {
    std::vector<StressCase> rows = stress_cases();
    rows.erase(std::remove_if(rows.begin(), rows.end(), [](const StressCase& row) { return !row.quick; }), rows.end());
    return rows;
}

class Stress : public testing::TestWithParam<StressCase> {};

TEST_P(Stress, Holds) {
    const StressResult result = run_case(GetParam(), device());
    EXPECT_EQ(result.error, "") << result.row.scene;
    for (const Measurement& m : result.measured)
        EXPECT_TRUE(m.holds()) << result.row.scene << ": " << m.what << " " << m.value << ", expected " << m.low << " to " << m.high;
}

std::string name_of(const testing::TestParamInfo<StressCase>& info) {
    std::string name = info.param.name;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Table, Stress, testing::ValuesIn(quick_cases()), name_of);

/// A row that measures one number.
StressCase row_of(double value) {
    return {"row", "", [value](const StressRun&) { return std::vector<Measurement>{below("number", value, 1)}; }};
}

TEST(StressVerdict, NumbersBeyondTheirBoundsAndErrorsFail) {
    EXPECT_EQ(run_case(row_of(0.5), device()).verdict, Verdict::holds);
    EXPECT_EQ(run_case(row_of(2), device()).verdict, Verdict::fails);
    EXPECT_EQ(run_case(row_of(std::nan("")), device()).verdict, Verdict::fails);
    StressCase broken = row_of(0.5);
    broken.run = [](const StressRun&) -> std::vector<Measurement> { throw std::runtime_error("broken"); };
    EXPECT_EQ(run_case(broken, device()).verdict, Verdict::fails);
}

TEST(StressTable, NamesAreUnique) {
    std::set<std::string> names;
    for (const StressCase& row : stress_cases()) EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

}  // namespace
