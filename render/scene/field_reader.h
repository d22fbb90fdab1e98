#pragma once
/// Reads described structs (field.h) from JSON objects. Fields that are absent and not required keep their value.

#include <optional>
#include <string>
#include <vector>

#include "render/scene/field.h"
#include "render/scene/json_fields.h"

namespace pdr {

class FieldReader {
  public:
    static constexpr bool kBranches = false;
    static constexpr bool kReads = true;

    /// Creates a reader of `fields`, which must outlive it. All visits throw FieldError.
    explicit FieldReader(JsonFields& fields) : fields_(fields) {}

    template <class T>
    void operator()(const Field& field, T& value) {
        if (field.required || fields_.has(field.name))
            fields_.required(field.name, value);
    }
    template <class T>
    void operator()(const Field& field, std::optional<T>& value) {
        if (fields_.has(field.name))
            fields_.required(field.name, value.emplace());
    }
    void direction(const Field& field, dvec3& value) { (*this)(field, value); }

    template <class T, std::size_t N>
    void word(const Field& field, T& value, const Words<T, N>& words) {
        if (field.required || fields_.has(field.name))
            fields_.required(field.name, value, words);
    }
    void labels(const Field& field, segment::Labels& value) { (*this)(field, value); }
    template <class T>
    void object(const Field& field, T& value) {
        if (field.required || fields_.has(field.name))
            read(fields_.object(field.name), value);
    }
    template <class T>
    void object(const Field& field, std::optional<T>& value) {
        if (fields_.has(field.name))
            read(fields_.object(field.name), value.emplace());
    }
    template <class T>
    void list(const Field& field, std::vector<T>& values) {
        if (!field.required && !fields_.has(field.name))
            return;
        values.clear();
        for (const JsonFields& one : fields_.objects(field.name))
            read(one, values.emplace_back());
    }

    /// Reads all fields of `value`; throws FieldError if the object holds any other field.
    template <class T>
    static void read(JsonFields fields, T& value) {
        FieldReader reader(fields);
        describe(reader, value);
        fields.finish();
    }

  private:
    JsonFields& fields_;
};

}  // namespace pdr
