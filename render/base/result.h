#pragma once
/// Results of functions that can fail: a value, or an Error written for the user.

#include <string>
#include <utility>
#include <variant>

#include "render/base/text.h"

namespace pdr {

/// Kind of an Error, by what a program can do about it.
enum class ErrorKind {
    failed,      ///< no further information: a later attempt may succeed
    refused,     ///< the request is wrong or not possible here: it would be refused again
    memory,      ///< too little memory: request less, or elsewhere
    deviceLost,  ///< the device does not respond: try elsewhere
    cancelled    ///< stopped on request: nothing to report
};

/// A failure in three short parts, each a plain sentence or phrase in the user's words. ui/ translates it.
///   what    what went wrong                    "slices 41 and 42 are 6 mm apart, the others 2 mm"
///   where   the file, series or field          "/data/ct/series3"
///   hint    what to do next; may be empty      "Import the part above slice 41."
struct Error {
    Text what;
    std::string where;
    Text hint;
    ErrorKind kind = ErrorKind::failed;

    /// Returns the error with `place`, which contains its `where`, in front of it.
    Error in(const std::string& place) const {
        Error error = *this;
        error.where = where.empty() ? place : place + ", " + where;
        return error;
    }
    /// Returns the error in one line: "where: what. hint"
    Text text() const {
        Text line = where.empty() ? what : phrase("%1: %2", where, what);
        if (hint.empty())
            return line;
        return phrase(line.empty() || line.back() == '.' ? "%1 %2" : "%1. %2", line, hint);
    }
};

/// Either a T or an Error. Accessing the one that is absent is a programming error (std::get throws).
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return content_.index() == 0; }
    T& value() & { return std::get<0>(content_); }
    const T& value() const& { return std::get<0>(content_); }
    T&& value() && { return std::get<0>(std::move(content_)); }
    const Error& error() const { return std::get<1>(content_); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }

  private:
    std::variant<T, Error> content_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)), ok_(false) {}

    explicit operator bool() const { return ok_; }
    const Error& error() const { return error_; }

  private:
    Error error_;
    bool ok_ = true;
};

}  // namespace pdr
