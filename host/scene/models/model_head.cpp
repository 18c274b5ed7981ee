// OBJ has no signature: its first statement tells it.
#include <algorithm>
#include <string>
#include <vector>

#include "scene/models/read_model.h"
#include "scene/text.h"

namespace pencil {

bool is_ply(std::string_view head) { return head.substr(0, 3) == "ply" && (head.size() == 3 || trimmed(head.substr(3, 1)).empty()); }

bool is_obj(std::string_view head) {
    const std::string decoded = decoded_by_mark(head);
    const std::string_view line = first_statement(decoded), word = line.substr(0, line.find_first_of(" \t"));
    const std::vector<std::string_view> keywords = tokens("v vt vn vp f o g s mtllib usemtl");
    return line.size() > word.size() && std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

}  // namespace pencil
