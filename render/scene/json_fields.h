#pragma once
/// Reads JSON objects strictly, field by field: a field that is missing, of the wrong kind, unknown or written twice is
/// an error that names its path ("lights[1].radiance"). Ranges are not checked here; the values check themselves.
///
/// Errors are thrown as FieldError; readJson() and readForeignJson() catch them.

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/scene/field.h"
#include "render/segment/labels.h"

namespace pdr {

struct FieldError {
    Error error;
};

class JsonFields {
  public:
    /// Reads from `value`, which must outlive this. Throws FieldError if it is not an object.
    JsonFields(const nlohmann::json& value, std::string path);

    const std::string& path() const { return path_; }
    bool has(std::string_view name);
    /// Returns the path of a field: "lights[1].radiance" for the field `radiance` of the object at "lights[1]".
    std::string pathOf(std::string_view name) const;

    // Each of these reads a field that must be present into `value`.
    void required(std::string_view name, double& value);
    void required(std::string_view name, float& value);
    void required(std::string_view name, int& value);
    void required(std::string_view name, std::uint64_t& value);
    void required(std::string_view name, bool& value);
    void required(std::string_view name, std::string& value);
    void required(std::string_view name, ivec3& value);
    void required(std::string_view name, dvec3& value);  ///< a place or a direction: [x, y, z]
    void required(std::string_view name, vec3& value);   ///< a colour: [r, g, b], or one number for all three
    void required(std::string_view name, std::pair<int, int>& value);
    void required(std::string_view name, segment::Labels& value);  ///< a list of different texts

    /// Reads a field that holds one of a few words.
    template <class T, std::size_t N>
    void required(std::string_view name, T& value, const Words<T, N>& words) {
        std::vector<std::string_view> known;
        for (const auto& [word, meaning] : words)
            known.push_back(word);
        value = words[wordIndex(name, known)].second;
    }

    JsonFields object(std::string_view name);
    std::vector<JsonFields> objects(std::string_view name);

    /// Throws FieldError if the object holds a field that was never asked for. Must be called last.
    void finish() const;
    [[noreturn]] void fail(std::string_view name, const Text& what, const Text& hint = {}) const;

  private:
    const nlohmann::json& field(std::string_view name);
    std::vector<double> numbers(std::string_view name, std::size_t count, const Text& shape);
    std::size_t wordIndex(std::string_view name, const std::vector<std::string_view>& words);

    const nlohmann::json* value_;
    std::string path_;
    std::set<std::string, std::less<>> known_;  ///< all fields that were asked for
};

/// Parses `text`, checks "format" and "version" (1), and passes the other fields to `read`. Refuses texts with more
/// than 64 nested lists and objects or more than a million values before parsing. Errors that `read` throws, and
/// invalid JSON, are returned as an error with `where` put before the field.
Result<void> readJson(std::string_view text, std::string_view where, std::string_view format,
                      const std::function<void(JsonFields&)>& read);
/// Parses `text` like readJson(), for file formats that others define: no format or version is checked, and fields that
/// are never asked for are ignored.
Result<void> readForeignJson(std::string_view text, std::string_view where,
                             const std::function<void(JsonFields&)>& read);

}  // namespace pdr
