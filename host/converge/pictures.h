// Images as data URIs, so that a page needs no other file.
#pragma once

#include <string>
#include <vector>

namespace pencil {

/// "data:MIME;base64,...".
std::string data_uri(const std::string& mime, const std::string& bytes);

/// A PNG of linear rgb times `exposure`; images wider than 400 pixels are averaged down by a whole factor.
std::string picture_uri(const std::vector<float>& rgb, int width, int height, double exposure);

}  // namespace pencil
