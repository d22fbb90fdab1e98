#pragma once
/// Checks the ranges of described structs (field.h). Rules between fields are left to the structs themselves.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/scene/field.h"
#include "render/segment/labels.h"

namespace pdr {

class FieldCheck {
  public:
    static constexpr bool kBranches = false;
    static constexpr bool kReads = false;

    /// Returns an error for the first field out of its range, with the field's path below `path`: "nodes[3].hu".
    template <class T>
    static Result<void> check(T value, const std::string& path = "") {
        FieldCheck check(path);
        describe(check, value);
        return std::move(check.result_);
    }

    void operator()(const Field& field, double value) { keep(checkRange(value, field.range, pathOf(field))); }
    void operator()(const Field& field, float value) { (*this)(field, double(value)); }
    void operator()(const Field& field, int value) { (*this)(field, double(value)); }
    void operator()(const Field& field, const vec3& value) { (*this)(field, dvec3(value)); }
    void operator()(const Field& field, const ivec3& value) { (*this)(field, dvec3(value)); }
    void operator()(const Field& field, const dvec3& value) { keep(checkRange(value, field.range, pathOf(field))); }
    void operator()(const Field& field, const std::pair<int, int>& value) {
        (*this)(field, dvec3(value.first, value.second, value.first));
    }
    void operator()(const Field&, bool) {}
    void operator()(const Field&, std::uint64_t) {}
    void operator()(const Field&, const std::string&) {}
    template <class T>
    void operator()(const Field& field, const std::optional<T>& value) {
        if (value)
            (*this)(field, *value);
    }
    void direction(const Field& field, const dvec3& value) { keep(checkDirection(value, pathOf(field))); }
    template <class T, std::size_t N>
    void word(const Field&, const T&, const Words<T, N>&) {}
    void labels(const Field&, const segment::Labels&) {}
    template <class T>
    void object(const Field& field, T& value) {
        below(pathOf(field), value);
    }
    template <class T>
    void object(const Field& field, std::optional<T>& value) {
        if (value)
            below(pathOf(field), *value);
    }
    template <class T>
    void list(const Field& field, std::vector<T>& values) {
        for (std::size_t i = 0; i < values.size() && result_; ++i)
            below(pathOf(field) + "[" + std::to_string(i) + "]", values[i]);
    }

  private:
    explicit FieldCheck(std::string path) : path_(std::move(path)) {}

    std::string pathOf(const Field& field) const {
        return path_.empty() ? std::string(field.name) : path_ + "." + std::string(field.name);
    }
    void keep(Result<void> checked) {
        if (result_ && !checked)
            result_ = std::move(checked);
    }
    template <class T>
    void below(std::string path, T& value) {
        std::swap(path_, path);
        describe(*this, value);
        std::swap(path_, path);
    }

    std::string path_;
    Result<void> result_;
};

}  // namespace pdr
