// Keywords in lines up to TILT=, then numbers with any separators. Profiles that say one half or quarter of the turn are completed by their
// symmetry.
#include "scene/read_ies.h"

#include <algorithm>
#include <cmath>

#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr double most_angles = 4096;

class IesReader {
public:
    IesReader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

    PhotometricData read() {
        skip_keywords();
        next();  // number of lamps
        next();  // lumens per lamp
        const double multiplier = next();
        const std::size_t rows = count("vertical"), columns = count("horizontal");
        if (next() != 1) fail("only photometry of type C is read");
        for (int i = 0; i < 4; ++i) next();  // units, width, length, height
        const double ballast = next();
        for (int i = 0; i < 2; ++i) next();  // factor of old files, watts
        PhotometricData data;
        data.profile.vertical = angles(rows, 180);
        data.profile.horizontal = angles(columns, 360);
        if (rows * columns > rest_.size()) fail("the file ends too early");
        std::vector<double> values;
        for (std::size_t i = 0; i < rows * columns; ++i) values.push_back(next() * multiplier * ballast);
        normalise(values, data);
        complete(data.profile);
        return data;
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw SceneError(name_, message); }

    void skip_keywords() {
        for (;;) {
            if (rest_.empty()) fail("this is no IES file: it has no line TILT=");
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            const std::string_view line = trimmed(rest_.substr(0, end));
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            if (line.substr(0, 5) != "TILT=") continue;
            if (line == "TILT=INCLUDE") skip_tilt();
            return;
        }
    }

    void skip_tilt() {
        next();  // geometry
        const std::size_t pairs = count("tilt");
        for (std::size_t i = 0; i < 2 * pairs; ++i) next();
    }

    double next() {
        constexpr std::string_view separators = " \t\r\n,";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(separators), rest_.size()));
        if (rest_.empty()) fail("the file ends too early");
        const std::string_view word = rest_.substr(0, rest_.find_first_of(separators));
        rest_.remove_prefix(word.size());
        const std::optional<double> value = parse_number(word);
        if (!value) fail(number_defect(word));
        return *value;
    }

    std::size_t count(const char* what) {
        const double value = next();
        if (!(value >= 1 && value <= most_angles) || value != std::floor(value))
            fail("the number of " + std::string(what) + " angles must be from 1 to 4096");
        return static_cast<std::size_t>(value);
    }

    std::vector<float> angles(std::size_t number, double largest) {
        std::vector<float> result;
        for (std::size_t i = 0; i < number; ++i) {
            const double angle = next();
            if (!(angle >= 0 && angle <= largest)) fail("an angle lies outside 0 to " + std::to_string(static_cast<int>(largest)));
            if (i > 0 && !(static_cast<float>(angle) > result.back())) fail("the angles must increase");
            result.push_back(static_cast<float>(angle));
        }
        return result;
    }

    void normalise(const std::vector<double>& values, PhotometricData& data) const {
        for (const double value : values)
            if (value < 0) fail("an intensity is negative");
        data.candela = *std::max_element(values.begin(), values.end());
        if (!(data.candela > 0) || !std::isfinite(data.candela)) fail("the lamp gives no light");
        for (const double value : values) data.profile.values.push_back(static_cast<float>(value / data.candela));
    }

    /// Of 0 to 90 degrees a quarter, of 0 to 180 a half is mirrored.
    static void complete(LightProfile& profile) {
        const std::size_t rows = profile.vertical.size();
        for (const float symmetry : {90.0F, 180.0F}) {
            if (profile.horizontal.size() < 2 || profile.horizontal.back() != symmetry) continue;
            for (std::size_t i = profile.horizontal.size() - 1; i-- > 0;) {
                profile.horizontal.push_back(2 * symmetry - profile.horizontal[i]);
                const std::vector<float> column(profile.values.begin() + static_cast<std::ptrdiff_t>(i * rows),
                                                profile.values.begin() + static_cast<std::ptrdiff_t>((i + 1) * rows));
                profile.values.insert(profile.values.end(), column.begin(), column.end());
            }
        }
    }

    std::string_view rest_;
    const std::string& name_;
};

}  // namespace

PhotometricData read_ies(std::string_view text, const std::string& name) { return IesReader(text, name).read(); }

}  // namespace pencil
