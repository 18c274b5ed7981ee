#include "converge/points.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "util/error.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

const char* const header =
    "method,budget,seed,seconds,build_seconds,rmse,rel_mse,mean_ratio,psnr_db,lab_rms,excluded_pixels,load,options,stages\n";
constexpr std::size_t columns = 14;

std::string number(double value) {
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
}

/// RFC 4180. Line breaks do not occur.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + "\"";
}

/// "film geometry=0.01;direct light=0.2"
std::string join_stages(const RunPoint& point) {
    std::string text;
    for (const auto& [name, seconds] : point.stages) {
        text += (text.empty() ? "" : ";") + name + "=" + number(seconds);
    }
    return text;
}

std::vector<std::string> split_line(const std::string& line) {
    std::vector<std::string> fields(1);
    bool inside = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool doubled = inside && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
        if (doubled) {
            fields.back() += line[++i];
        } else if (line[i] == '"') {
            inside = !inside;
        } else if (line[i] == ',' && !inside) {
            fields.emplace_back();
        } else {
            fields.back() += line[i];
        }
    }
    return fields;
}

template <typename T>
bool reads_as(const std::string& text, T& value) {
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && stop == text.data() + text.size();
}

bool read_stages(const std::string& text, RunPoint& point) {
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find(';', start), text.size());
        const std::string part = text.substr(start, end - start);
        const std::size_t equals = part.rfind('=');
        double seconds = 0;
        if (equals == std::string::npos || !reads_as(part.substr(equals + 1), seconds)) {
            return false;
        }
        point.stages.emplace_back(part.substr(0, equals), seconds);
        start = end + 1;
    }
    return true;
}

bool read_point(const std::string& line, RunPoint& point) {
    const std::vector<std::string> fields = split_line(line);
    if (fields.size() != columns) {
        return false;
    }
    point.method = fields[0];
    point.options = fields[12];
    return reads_as(fields[1], point.budget) && reads_as(fields[2], point.seed) && reads_as(fields[3], point.seconds) &&
           reads_as(fields[4], point.build_seconds) && reads_as(fields[5], point.rmse) && reads_as(fields[6], point.rel_mse) &&
           reads_as(fields[7], point.mean_ratio) && reads_as(fields[8], point.psnr) && reads_as(fields[9], point.lab_rms) &&
           reads_as(fields[10], point.excluded_pixels) && reads_as(fields[11], point.load) && read_stages(fields[13], point);
}

[[noreturn]] void cannot_write(const fs::path& file) { throw OutputError("cannot write " + file.string() + ": " + std::strerror(errno)); }

}  // namespace

std::vector<RunPoint> read_points(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return {};
    }
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::size_t whole = text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1;
    if (whole < text.size()) {
        fs::resize_file(file, whole);
    }
    std::vector<RunPoint> points;
    int line_number = 0;
    for (std::size_t start = 0; start < whole; ++line_number) {
        const std::size_t end = text.find('\n', start);
        const std::string line = text.substr(start, end - start);
        start = end + 1;
        RunPoint point;
        const bool readable = line_number == 0 ? line + "\n" == header : read_point(line, point);
        if (!readable) {
            throw OutputError(file.string() + ":" + std::to_string(line_number + 1) +
                              ": not a row of this version's runs; use another folder, or delete the file to measure again");
        }
        if (line_number > 0) {
            points.push_back(std::move(point));
        }
    }
    return points;
}

void append_point(const fs::path& file, const RunPoint& point) {
    std::error_code absent;
    const std::uintmax_t size = fs::file_size(file, absent);
    std::string row = absent || size == 0 ? header : "";
    row += point.method + "," + std::to_string(point.budget) + "," + std::to_string(point.seed);
    for (const double value :
         {point.seconds, point.build_seconds, point.rmse, point.rel_mse, point.mean_ratio, point.psnr, point.lab_rms}) {
        row += "," + number(value);
    }
    row += "," + std::to_string(point.excluded_pixels) + "," + number(point.load) + "," + quoted(point.options) + "," +
           quoted(join_stages(point)) + "\n";
    errno = 0;
    std::ofstream stream(file, std::ios::binary | std::ios::app);
    stream.write(row.data(), static_cast<std::streamsize>(row.size()));
    stream.close();
    if (!stream) {
        cannot_write(file);
    }
}

}  // namespace pencil
