#pragma once
/// What a border function hands back: a value, or an Error written for the person at the screen.

#include <string>
#include <utility>
#include <variant>

#include "render/base/text.h"

namespace pdr {

/// What a program can do about an Error.
enum class ErrorKind {
    failed,      ///< no more is known: it may work another time
    refused,     ///< what was asked for is wrong or not possible here: the same would be refused again
    memory,      ///< too little of it: less, or elsewhere
    deviceLost,  ///< what should have done it does not answer: elsewhere
    cancelled    ///< it was asked to stop: nothing to tell
};

/// A failure in three short parts, each a plain sentence or phrase in the user's words. ui/ says it in other languages.
///   what    what went wrong                    "slices 41 and 42 are 6 mm apart, the others 2 mm"
///   where   the file, series or field          "/data/ct/series3"
///   hint    what to do next; may be empty      "Import the part above slice 41."
struct Error {
    Text what;
    std::string where;
    Text hint;
    ErrorKind kind = ErrorKind::failed;

    /// The same, in something that holds its `where`.
    Error in(const std::string& place) const {
        Error error = *this;
        error.where = where.empty() ? place : place + ", " + where;
        return error;
    }
    /// One line: "where: what. hint"
    Text text() const {
        Text line = where.empty() ? what : phrase("%1: %2", where, what);
        if (hint.empty())
            return line;
        return phrase(line.empty() || line.back() == '.' ? "%1 %2" : "%1. %2", line, hint);
    }
};

/// Either a T or an Error. Asking for the part that is not there is a programming error (std::get throws).
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
