#include "scene/meshes/read_mtl.h"

#include <algorithm>
#include <cctype>

#include "scene/text.h"

namespace pencil {
namespace {

constexpr std::size_t most_defects = 100;  // that are told

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

class MtlReader {
public:
    MtlReader(std::string_view text, const std::string& name, std::vector<SceneError>& defects)
        : text_(text), name_(name), defects_(defects) {}

    std::vector<MtlMaterial> read() {
        for (std::size_t start = 0; start < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', start), text_.size());
            ++line_;
            try {
                statement(trimmed(text_.substr(start, end - start)));
            } catch (const SceneError& defect) {
                if (defects_.size() < most_defects) defects_.push_back(defect);
            }
            start = end + 1;
        }
        return std::move(materials_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw SceneError(name_ + ":" + std::to_string(line_), message); }

    static std::string_view next_word(std::string_view& rest) {
        const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
        const std::string_view word = rest.substr(0, end);
        rest = trimmed(rest.substr(end));
        return word;
    }

    void statement(std::string_view line) {
        if (line.empty() || line[0] == '#') return;
        const std::string keyword = lower(next_word(line));
        if (keyword == "newmtl") {
            materials_.emplace_back();
            materials_.back().name = line;
            return;
        }
        if (materials_.empty()) return;
        MtlMaterial& m = materials_.back();
        if (keyword == "kd") m.diffuse = colour(line);
        if (keyword == "ks") m.specular = colour(line);
        if (keyword == "ke") m.emission = colour(line);
        if (keyword == "tf") m.filter = colour(line);
        if (keyword == "ns") m.exponent = number(line);
        if (keyword == "ni") m.index = number(line);
        if (keyword == "pr") m.roughness = number(line);
        if (keyword == "pm") m.metallic = number(line);
        if (keyword == "d") m.opacity = number(line.substr(0, 5) == "-halo" ? trimmed(line.substr(5)) : line);
        if (keyword == "tr" && !m.opacity) m.opacity = 1 - number(line);
        if (keyword == "illum") m.model = static_cast<int>(std::clamp(number(line), 0.0, 100.0));
        if (keyword == "map_kd") m.diffuse_map = map(line);
        if (keyword == "map_ks") m.specular_map = map(line);
        if (keyword == "map_ke") m.emission_map = map(line);
        if (keyword == "map_d") m.opacity_map = map(line);
        if (keyword == "map_bump" || keyword == "bump") m.bump_map = map(line);
        if (keyword == "norm" || keyword == "map_kn") m.normal_map = map(line);
        constexpr std::string_view others = "map_ks map_ns map_ps map_pr map_pm map_tf disp decal refl aniso anisor pc pcr ps";
        const std::vector<std::string_view> list = tokens(others);
        if (std::find(list.begin(), list.end(), keyword) != list.end()) m.left_out.push_back(keyword);
    }

    double number(std::string_view line) const {
        const std::string_view word = next_word(line);
        const std::optional<double> value = parse_number(word);
        if (!value) fail(number_defect(word));
        return *value;
    }

    /// One number stands for three. Colours by spectra or in CIE XYZ are none that anyone writes: empty.
    std::optional<glm::dvec3> colour(std::string_view line) const {
        const std::vector<std::string_view> words = tokens(line);
        if (!words.empty() && (words[0] == "spectral" || words[0] == "xyz")) return std::nullopt;
        glm::dvec3 result(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string_view word = words.empty() ? std::string_view() : words[words.size() >= 3 ? k : 0];
            const std::optional<double> value = parse_number(word);
            if (!value) fail(number_defect(word));
            result[static_cast<int>(k)] = std::max(*value, 0.0);
        }
        return result;
    }

    /// Options, each with its operands, then the file, whose name may hold blanks.
    MtlMap map(std::string_view line) const {
        MtlMap result;
        while (!line.empty() && line[0] == '-') {
            const std::string option = lower(next_word(line));
            if (option == "-o" || option == "-s" || option == "-t") {
                glm::dvec3 values(option == "-s" ? 1.0 : 0.0);
                numbers(line, values);
                if (option == "-o") result.offset = values;
                if (option == "-s") result.scale = values;
            } else if (option == "-mm") {
                next_word(line);
                next_word(line);
            } else {
                const std::string_view operand = next_word(line);
                if (option == "-clamp") result.clamp = lower(operand) == "on";
                if (option == "-bm") result.bump_multiplier = parse_number(operand).value_or(1.0);
            }
        }
        result.file = line;
        return result;
    }

    /// Up to three.
    static void numbers(std::string_view& line, glm::dvec3& values) {
        for (int k = 0; k < 3; ++k) {
            std::string_view rest = line;
            const std::optional<double> value = parse_number(next_word(rest));
            if (!value || rest.empty()) return;  // the file's name
            values[k] = *value;
            line = rest;
        }
    }

    std::string_view text_;
    const std::string& name_;
    std::vector<SceneError>& defects_;
    std::size_t line_ = 0;
    std::vector<MtlMaterial> materials_;
};

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& name, std::vector<SceneError>& defects) {
    const std::string decoded = decoded_by_mark(text);
    return MtlReader(decoded, name, defects).read();
}

}  // namespace pencil
