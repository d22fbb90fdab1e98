#pragma once
/// Makes the manual's table of a described struct (field.h), in Markdown.

#include <optional>
#include <string>
#include <vector>

#include "render/scene/field.h"
#include "render/segment/labels.h"

namespace pdr {

class FieldTable {
  public:
    static constexpr bool kBranches = true;
    static constexpr bool kReads = false;

    /// Returns the table of a new T's fields: name, meaning, range and default; "-" as the default of a required field.
    template <class T>
    static std::string of(T fresh = {}) {
        FieldTable table;
        describe(table, fresh);
        return table.text_;
    }

    void operator()(const Field& field, double value) { row(field, range(field.range), numberText(value, 6)); }
    void operator()(const Field& field, int value) { (*this)(field, double(value)); }
    void operator()(const Field& field, float value) { row(field, range(field.range), numberText(value, 6)); }
    void operator()(const Field& field, const vec3& value) { (*this)(field, dvec3(value)); }
    void operator()(const Field& field, const ivec3& value) { (*this)(field, dvec3(value)); }
    void operator()(const Field& field, const dvec3& value) { row(field, "each " + range(field.range), list(value)); }
    void operator()(const Field& field, const std::pair<int, int>&) {
        row(field, "two whole numbers " + range(field.range), "none");
    }
    void operator()(const Field& field, bool value) { row(field, "`true` or `false`", value ? "`true`" : "`false`"); }
    void operator()(const Field& field, std::uint64_t value) {
        row(field, "0 to 18446744073709551615", std::to_string(value));
    }
    void operator()(const Field& field, const std::string&) { row(field, "text", "none"); }
    template <class T>
    void operator()(const Field& field, const std::optional<T>&) {
        FieldTable one;
        one(field, T{});
        const std::size_t last = one.text_.rfind("| ");
        text_ += one.text_.substr(kHead.size(), last - kHead.size()) + "| none |\n";
    }
    void direction(const Field& field, const dvec3& value) { row(field, "a direction", list(value)); }
    template <class T, std::size_t N>
    void word(const Field& field, const T& value, const Words<T, N>& words) {
        std::string all, mine;
        for (const auto& [word, meaning] : words) {
            all += (all.empty() ? "`" : ", `") + std::string(word) + "`";
            if (meaning == value)
                mine = "`" + std::string(word) + "`";
        }
        row(field, all, mine);
    }
    void labels(const Field& field, const segment::Labels&) { row(field, "a list of `bones`, `lungs`", "`[]`"); }
    template <class T>
    void object(const Field& field, T&) {
        row(field, "see below", "see below");
    }
    template <class T>
    void list(const Field& field, std::vector<T>&) {
        row(field, "see below", "none");
    }

  private:
    static constexpr std::string_view kHead = "| field | what it is | range | default |\n|---|---|---|---|\n";

    static std::string range(const Range& range) { return range.lowest == kAnyNumber.lowest ? "finite" : range.text(); }
    static std::string list(const dvec3& value) {
        if (value.x == value.y && value.y == value.z)
            return numberText(value.x, 6);
        return "`[" + numberText(value.x, 6) + ", " + numberText(value.y, 6) + ", " + numberText(value.z, 6) + "]`";
    }
    void row(const Field& field, const std::string& range, const std::string& fallback) {
        text_ += "| `" + std::string(field.name) + "` | " + std::string(field.meaning) + " | " + range + " | " +
                 (field.required ? "-" : fallback) + " |\n";
    }

    std::string text_{kHead};
};

}  // namespace pdr
