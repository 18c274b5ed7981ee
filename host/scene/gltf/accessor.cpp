// Divisions instead of products: a lying count or offset overflows these.
#include "scene/gltf/accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace pencil {
namespace {

/// Of accessors without a buffer, whose count nothing else holds against the size of the file.
constexpr std::size_t most_zeros = std::size_t{1} << 18;

template <class T>
double decode(const char* bytes, bool normalized) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    if (!normalized || !std::numeric_limits<T>::is_integer) return static_cast<double>(value);
    // The most negative integer and the one above it both stand for -1.
    return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

using Decode = double (*)(const char*, bool);

/// Null for what is no type of component.
Decode decoder_of(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return decode<std::int8_t>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return decode<std::uint8_t>;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return decode<std::int16_t>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return decode<std::uint16_t>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return decode<std::uint32_t>;
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return decode<float>;
        default:
            return nullptr;
    }
}

bool is_unsigned(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// Matrices are no attribute of a vertex: 0.
int components_of(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        default:
            return 0;
    }
}

std::size_t size_of(int component) { return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(component))); }

}  // namespace

std::string_view AccessorReader::bytes(int index, const std::string& user) const {
    const tinygltf::BufferView& view = file_.at(file_.model().bufferViews, index, "buffer view", user);
    const tinygltf::Buffer& buffer = file_.at(file_.model().buffers, view.buffer, "buffer", "buffer view " + std::to_string(index));
    const std::size_t size = buffer.data.size();
    if (view.byteOffset > size || view.byteLength > size - view.byteOffset)
        file_.fail("buffer view " + std::to_string(index) + " reaches beyond the end of its buffer of " + std::to_string(size) + " bytes");
    return {reinterpret_cast<const char*>(buffer.data.data()) + view.byteOffset, view.byteLength};
}

AccessorReader::Elements AccessorReader::elements(int view, std::size_t offset, std::size_t count, std::size_t size, bool may_stride,
                                                  const std::string& user) const {
    const std::string_view content = bytes(view, user);
    const std::size_t given = may_stride ? file_.model().bufferViews[static_cast<std::size_t>(view)].byteStride : 0;
    const std::size_t stride = given > 0 ? given : size;
    if (stride < size) file_.fail(user + ": elements of " + std::to_string(size) + " bytes lie only " + std::to_string(stride) + " apart");
    const bool fits = offset <= content.size() && size <= content.size() - offset &&
                      (count == 0 || count - 1 <= (content.size() - offset - size) / stride);
    if (count > 0 && !fits) {
        file_.fail(user + " needs " + std::to_string(count) + " elements of buffer view " + std::to_string(view) + ", which has only " +
                   std::to_string(content.size()) + " bytes");
    }
    return {count > 0 ? content.data() + offset : content.data(), count, size, stride};
}

int AccessorReader::components(int index, const std::string& user) const {
    return components_of(file_.at(file_.model().accessors, index, "accessor", user).type);
}

std::vector<double> AccessorReader::numbers(int index, int components, const std::string& user) const {
    const tinygltf::Accessor& accessor = file_.at(file_.model().accessors, index, "accessor", user);
    const std::string label = user + ": accessor " + std::to_string(index);
    const Decode decode = decoder_of(accessor.componentType);
    const int held = components_of(accessor.type);
    if (!decode) file_.fail(label + " has components of unknown type " + std::to_string(accessor.componentType));
    if (held < components) {
        file_.fail(label + " has " + (held == 0 ? "matrices" : std::to_string(held) + " numbers for each element") + ", not " +
                   std::to_string(components));
    }
    std::vector<double> values;
    if (accessor.bufferView >= 0) {
        const std::size_t step = size_of(accessor.componentType);
        const Elements all =
            elements(accessor.bufferView, accessor.byteOffset, accessor.count, step * static_cast<std::size_t>(held), true, label);
        values.reserve(all.count * static_cast<std::size_t>(components));
        for (std::size_t i = 0; i < all.count; ++i)
            for (int c = 0; c < components; ++c)
                values.push_back(decode(all.first + i * all.stride + static_cast<std::size_t>(c) * step, accessor.normalized));
    } else {
        if (accessor.count > most_zeros) file_.fail(label + " has " + std::to_string(accessor.count) + " elements and no buffer");
        values.resize(accessor.count * static_cast<std::size_t>(components), 0.0);
    }
    if (accessor.sparse.isSparse) apply_sparse(accessor, components, values, label);
    return values;
}

void AccessorReader::apply_sparse(const tinygltf::Accessor& accessor, int components, std::vector<double>& values,
                                  const std::string& user) const {
    const auto& sparse = accessor.sparse;
    const std::string label = user + " (sparse)";
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) file_.fail(label + " has a negative size");
    if (!is_unsigned(sparse.indices.componentType)) file_.fail(label + " has indices that are no unsigned integers");
    const auto count = static_cast<std::size_t>(sparse.count), step = size_of(accessor.componentType);
    const Elements places = elements(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
                                     size_of(sparse.indices.componentType), false, label);
    const Elements replaced = elements(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
                                       step * static_cast<std::size_t>(components_of(accessor.type)), false, label);
    const Decode index_at = decoder_of(sparse.indices.componentType), decode = decoder_of(accessor.componentType);
    for (std::size_t i = 0; i < count; ++i) {
        const auto place = static_cast<std::size_t>(index_at(places.first + i * places.stride, false));
        if (place >= accessor.count)
            file_.fail(label + " replaces element " + std::to_string(place) + ", but there are " + std::to_string(accessor.count));
        for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c) {
            values[place * static_cast<std::size_t>(components) + c] =
                decode(replaced.first + i * replaced.stride + c * step, accessor.normalized);
        }
    }
}

std::vector<std::uint32_t> AccessorReader::indices(int index, const std::string& user) const {
    const tinygltf::Accessor& accessor = file_.at(file_.model().accessors, index, "accessor", user);
    if (!is_unsigned(accessor.componentType) || accessor.type != TINYGLTF_TYPE_SCALAR || accessor.normalized)
        file_.fail(user + ": accessor " + std::to_string(index) + " does not hold unsigned integers");
    const std::vector<double> values = numbers(index, 1, user);
    std::vector<std::uint32_t> result;
    result.reserve(values.size());
    for (const double value : values) result.push_back(static_cast<std::uint32_t>(value));
    return result;
}

}  // namespace pencil
