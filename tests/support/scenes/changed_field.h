#pragma once
/// Changes one field after another of a described struct (render/scene/field.h), each as little as possible.

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "render/scene/field.h"
#include "render/scene/fields/light_fields.h"
#include "render/scene/fields/scene_fields.h"

namespace pdr::test {

/// Changes the field number `index` of those that it visits: a number by its last bit, a list or an optional value by
/// having or lacking an element.
class ChangedField {
  public:
    static constexpr bool kBranches = false;
    static constexpr bool kReads = false;

    explicit ChangedField(std::size_t index) : index_(index) {}

    /// Name of the field that was changed, with those around it; empty: there are not so many.
    const std::string& name() const { return name_; }

    void operator()(const Field& field, double& value) {
        change(field, [&] { value = std::nextafter(value, 1e300); });
    }
    void operator()(const Field& field, float& value) {
        change(field, [&] { value = std::nextafter(value, 1e30f); });
    }
    void operator()(const Field& field, int& value) {
        change(field, [&] { ++value; });
    }
    void operator()(const Field& field, std::uint64_t& value) {
        change(field, [&] { ++value; });
    }
    void operator()(const Field& field, bool& value) {
        change(field, [&] { value = !value; });
    }
    void operator()(const Field& field, std::string& value) {
        change(field, [&] { value += "x"; });
    }
    void operator()(const Field& field, vec3& value) { each(field, value); }
    void operator()(const Field& field, dvec3& value) { each(field, value); }
    void operator()(const Field& field, ivec3& value) { each(field, value); }
    template <class T>
    void operator()(const Field& field, std::optional<T>& value) {
        optional(field, value, [&](T& one) { (*this)(field, one); });
    }
    void direction(const Field& field, dvec3& value) { each(field, value); }
    template <class T, std::size_t N>
    void word(const Field& field, T& value, const Words<T, N>& words) {
        change(field, [&] { value = words[0].second == value ? words[1].second : words[0].second; });
    }
    void labels(const Field& field, segment::Labels& value) {
        change(field, [&] { value.insert("x"); });
    }
    template <class T>
    void object(const Field& field, T& value) {
        const std::string around = around_;
        around_ += std::string(field.name) + ".";
        describe(*this, value);
        around_ = around;
    }
    template <class T>
    void object(const Field& field, std::optional<T>& value) {
        optional(field, value, [&](T& one) { object(field, one); });
    }
    template <class T>
    void list(const Field& field, std::vector<T>& values) {
        const std::size_t size = values.size();
        change(field, [&] { values.resize(size + 1); });
        for (std::size_t i = 0; i < size; ++i)
            object(field, values[i]);
    }

  private:
    template <class Change>
    void change(const Field& field, const Change& change) {
        if (count_++ != index_)
            return;
        name_ = around_ + std::string(field.name);
        change();
    }
    template <class V>
    void each(const Field& field, V& value) {
        for (int i = 0; i < 3; ++i)
            (*this)(field, value[i]);
    }
    template <class T, class Inside>
    void optional(const Field& field, std::optional<T>& value, const Inside& inside) {
        const bool had = value.has_value();
        change(field, [&] { had ? value.reset() : void(value.emplace()); });
        if (had && value)
            inside(*value);
    }

    std::size_t index_, count_ = 0;
    std::string name_, around_;
};

}  // namespace pdr::test
