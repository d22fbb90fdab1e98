#pragma once
/// Sets the fields of described structs to random values, each from its whole range (render/scene/field.h).

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "render/scene/fields/light_fields.h"
#include "render/scene/fields/look_fields.h"
#include "render/scene/fields/scene_fields.h"
#include "render/scene/fields/volume_fields.h"

namespace pdr::test {

class RandomFields {
  public:
    static constexpr bool kBranches = false;
    static constexpr bool kReads = true;

    explicit RandomFields(unsigned seed) : random_(seed) {}

    void operator()(const Field& field, double& value) { value = number(field.range); }
    /// Draws again if single precision rounds a value to a limit that the range excludes.
    void operator()(const Field& field, float& value) {
        do
            value = float(number(field.range));
        while (!field.range.holds(value));
    }
    void operator()(const Field& field, int& value) { value = int(std::trunc(number(field.range))); }
    void operator()(const Field& field, vec3& value) { each(field, value); }
    void operator()(const Field& field, dvec3& value) { each(field, value); }
    void operator()(const Field& field, ivec3& value) { each(field, value); }
    void operator()(const Field& field, std::pair<int, int>& value) {
        (*this)(field, value.first);
        (*this)(field, value.second);
    }
    void operator()(const Field&, bool& value) { value = chance(); }
    void operator()(const Field&, std::uint64_t& value) {
        value = std::uniform_int_distribution<std::uint64_t>()(random_);
    }
    void operator()(const Field&, std::string& value) { value = "text \"" + std::to_string(random_()) + "\" \\ äöü"; }
    template <class T>
    void operator()(const Field& field, std::optional<T>& value) {
        value.reset();
        if (chance())
            (*this)(field, value.emplace());
    }
    void direction(const Field&, dvec3& value) {
        std::normal_distribution<double> normal;
        const double length = std::pow(10.0, 20 * normal(random_));
        for (int i = 0; i < 3; ++i)
            value[i] = length * normal(random_);
    }
    template <class T, std::size_t N>
    void word(const Field&, T& value, const Words<T, N>& words) {
        value = words[random_() % N].second;
    }
    void labels(const Field& field, segment::Labels& value) {
        value.clear();
        for (unsigned i = random_() % 3; i > 0; --i) {
            std::string label;
            (*this)(field, label);
            value.insert(label);
        }
    }
    template <class T>
    void object(const Field&, T& value) {
        describe(*this, value);
    }
    template <class T>
    void object(const Field& field, std::optional<T>& value) {
        value.reset();
        if (chance())
            object(field, value.emplace());
    }
    template <class T>
    void list(const Field& field, std::vector<T>& values) {
        values.resize((field.required ? 1 : 0) + random_() % 5);
        for (T& value : values)
            object(field, value);
    }

  private:
    bool chance() { return random_() % 2 == 0; }
    /// Draws a number: uniformly, or uniformly in its logarithm, or a limit of the range.
    double number(const Range& range) {
        const double u = std::uniform_real_distribution<double>()(random_);
        double value = range.lowest / 2 + (range.highest / 2 - range.lowest / 2) * u;
        value *= value < range.highest / 2 || value > range.lowest / 2 ? 1 : 2;
        if (random_() % 3 == 0)
            value = std::copysign(std::pow(10.0, -8 + 16 * u), value);
        if (random_() % 10 == 0)
            value = chance() ? range.lowest : range.highest;
        return range.holds(value) ? value : number(range);
    }
    template <class V>
    void each(const Field& field, V& value) {
        for (int i = 0; i < 3; ++i)
            (*this)(field, value[i]);
    }

    std::mt19937 random_;
};

}  // namespace pdr::test
