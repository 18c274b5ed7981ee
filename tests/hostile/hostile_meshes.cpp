// Rows 12 to 19: OBJ with its MTL, and PLY, opened directly.
#include <cstring>

#include "hostile/hostile_case.h"

namespace pencil_test {
namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

HostileCase obj(const std::string& name, int code, const std::string& says, const std::string& text) {
    return reads(
        name, code, says, "a.obj", [=] { return text; });
}

/// A regular polygon of so many corners.
std::string large_polygon(int count) {
    std::string text, face = "f";
    for (int i = 0; i < count; ++i) {
        text += "v " + std::to_string(i % 1000) + " " + std::to_string(i / 1000) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    return text + face + "\n";
}

std::vector<HostileCase> objects() {
    return {
        obj("12-face-of-0", 3, "a.obj:4", corners + "f 0 1 2\n"),
        obj("12-face-beyond", 3, "a.obj:4", corners + "f 1 2 4\n"),
        obj("12-face-before", 3, "a.obj:4", corners + "f 1 2 -999\n"),
        obj("12-face-of-2^31", 3, "a.obj:4", corners + "f 1 2 2147483648\n"),
        obj("12-face-of-2^63", 3, "a.obj:4", corners + "f 1 2 9223372036854775808\n"),
        obj("13-face-of-two", 0, "fewer than 3 corners", corners + "f 1 2\nf 1 2 3\n"),
        obj("13-face-of-one-point", 0, "", corners + "f 1 1 1\nf 1 2 3\n"),
        reads(
            "13-face-of-2e5", 0, "", "a.obj", [] { return large_polygon(200000); }),
        obj("14-vertex-of-two", 3, "a.obj:1", "v 0 0\n"),
        obj("14-vertex-of-seven", 0, "", "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3"),
        obj("14-corners-of-nothing", 0, "", corners + "f 1/7/7 2/8/8 3/9/9\n"),
        reads(
            "14-line-of-10-mb", 0, "", "a.obj", [] { return corners + "# " + std::string(10 << 20, 'x') + "\nf 1 2 3\n"; }),
        reads(
            "14-continued-1e6-times", 0, "", "a.obj", [] { return corners + "f 1 2 " + repeated("\\\n", 1000000) + "3\n"; }),
        obj("15-mtl-missing", 0, "none.mtl", "mtllib none.mtl\n" + corners + "f 1 2 3\n"),
        {"15-mtl-outside", 0, "",
         [](const Folder& folder) {
             return Arguments{"info", folder.write("a.obj", "mtllib ../../etc/passwd\n" + corners + "f 1 2 3\n")};
         }},
        {"15-map-outside", 0, "",
         [](const Folder& folder) {
             folder.write("a.mtl", "newmtl m\nmap_Kd ../../etc/passwd\nmap_Ks /etc/passwd\n");
             return Arguments{"info", folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + corners + "f 1 2 3\n")};
         }},
    };
}

std::string ply_head(const std::string& format, const std::string& vertices, const std::string& faces,
                     const std::string& length = "uchar") {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces + "\nproperty list " + length +
           " int vertex_indices\nend_header\n";
}

std::string floats(const std::vector<float>& values) {
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

std::vector<HostileCase> polygons() {
    const std::string triangle = floats({0, 0, 0, 1, 0, 0, 0, 1, 0}), little = "binary_little_endian";
    const auto ply = [](const std::string& name, int code, const std::string& says, const std::string& text) {
        return reads(name, code, says, "a.ply", [=] { return text; });
    };
    std::vector<HostileCase> cases;
    for (const std::string count : {"1000000000", "9223372036854775807", "18446744073709551616", "-1"})
        for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"})
            cases.push_back(ply("16-" + count + "-vertices-" + format, 3, "a.ply:3", ply_head(format, count, "0") + triangle));
    const std::vector<HostileCase> more{
        ply("16-no-vertices", 3, "", ply_head(little, "0", "0")),
        ply("16-faces-1e18", 3, "a.ply", ply_head(little, "3", "1000000000000000000") + triangle),
        ply("17-list-of-2^32", 3, "", ply_head(little, "3", "1", "uint") + triangle + std::string(4, '\xff')),
        ply("17-list-of--1", 3, "", ply_head(little, "3", "1", "char") + triangle + std::string(4, '\xff')),
        ply("17-list-of-doubles", 3, "", ply_head(little, "3", "1", "double") + triangle),
        ply("18-unknown-type", 3, "half", "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n"),
        ply("18-no-end", 3, "", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"),
        ply("18-header-of-10-mb", 3, "", "ply\nformat ascii 1.0\n" + repeated("comment nothing\n", 700000)),
        ply("18-a-million-properties", 3, "",
            "ply\nformat ascii 1.0\nelement vertex 1\n" + repeated("property float x\n", 1000000) + "end_header\n"),
        ply("18-extra-columns", 3, "", ply_head("ascii", "1", "0") + "0 0 0 0 0\n"),
        ply("19-nowhere", 3, "", ply_head("ascii", "3", "1") + "nan 0 0\ninf 0 0\n0 0 0\n3 0 1 2\n"),
        ply("19-1e38", 3, "1e18", ply_head("ascii", "3", "1") + "1e38 0 0\n0 1 0\n0 0 1\n3 0 1 2\n"),
    };
    cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}  // namespace

std::vector<HostileCase> hostile_meshes() {
    std::vector<HostileCase> cases = objects();
    for (HostileCase& polygon : polygons()) cases.push_back(polygon);
    return cases;
}

}  // namespace pencil_test
