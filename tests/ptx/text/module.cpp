#include "tests/ptx/text/module.h"

#include <algorithm>

#include "tests/ptx/base/findings.h"

namespace pdr::ptx {

namespace {

/// Reads the body of a kernel, which is one scope. Statements end at a semicolon, labels at a colon; braces inside a
/// statement hold vectors.
class BodyReader {
  public:
    BodyReader(KernelText& kernel, std::string_view text, std::size_t at, int line)
        : kernel_(kernel), text_(text), at_(at), line_(line) {}

    void read() {
        while (skipBlanks())
            if (!readLabel())
                readStatement();
    }

  private:
    [[noreturn]] void stop(const std::string& what) const {
        throw NotKnown("line " + std::to_string(line_) + ": " + what);
    }

    /// Goes on to the next word; false: the body has ended.
    bool skipBlanks() {
        for (;; ++at_) {
            if (at_ >= text_.size())
                stop("the kernel does not end");
            if (text_.substr(at_, 2) == "//")
                at_ = text_.find('\n', at_);
            const char c = text_[at_];
            if (c == '\n')
                ++line_;
            else if (c == '{')
                stop("a scope inside a kernel");
            else if (c != ' ' && c != '\t' && c != '\r')
                return c != '}';
        }
    }

    bool readLabel() {
        const std::size_t end = text_.find_first_of(": \t\n;", at_);
        if (text_[end] != ':')
            return false;
        kernel_.statements.push_back({line_, std::string(text_.substr(at_, end - at_)), {}, {}, {}});
        at_ = end + 1;
        return true;
    }

    void readStatement() {
        const std::size_t end = text_.find(';', at_);
        const std::string_view all = text_.substr(at_, end - at_);
        add(trimmed(all));
        line_ += int(std::count(all.begin(), all.end(), '\n'));
        at_ = end + 1;
    }

    void add(std::string_view text) {
        if (text.front() == '.')
            return declare(text);
        Statement statement{line_, {}, {}, {}, {}};
        if (text.front() == '@')
            statement.guard = takeWord(text).substr(1);
        statement.operation = takeWord(text);
        statement.operands = cutOperands(text);
        kernel_.statements.push_back(std::move(statement));
    }

    void declare(std::string_view text) {
        const std::string_view directive = takeWord(text);
        if (directive == ".reg") {
            const std::string type(takeWord(text).substr(1));
            for (const std::string& set : cutOperands(text))
                kernel_.registers.push_back(registerSet(type, set));
        } else if (directive == ".local") {
            const Declaration variable = declarationIn(text);
            kernel_.locals[variable.name] = variable.placeBehind(kernel_.localBytes);
        } else if (directive != ".pragma") {  // pragmas are for the assembler
            stop("directive " + std::string(directive));
        }
    }

    KernelText& kernel_;
    std::string_view text_;
    std::size_t at_;
    int line_;
};

}  // namespace

Module::Module(std::string text) : text_(std::move(text)) {
    constexpr std::string_view kEntry = ".entry ";
    for (std::size_t at = text_.find(kEntry); at != text_.npos; at = text_.find(kEntry, at)) {
        at += kEntry.size();
        const std::size_t parenthesis = text_.find('(', at);
        at_[std::string(trimmed(std::string_view(text_).substr(at, parenthesis - at)))] = parenthesis + 1;
    }
}

std::vector<std::string> Module::kernels() const {
    std::vector<std::string> names;
    for (const auto& [name, at] : at_)
        names.push_back(name);
    return names;
}

KernelText Module::kernel(const std::string& name) const {
    KernelText kernel;
    kernel.name = name;
    const std::string_view all = text_;
    const std::size_t begin = at_.at(name), closed = all.find(")\n", begin), body = all.find('{', closed) + 1;
    for (std::string_view one : cutOperands(all.substr(begin, closed - begin))) {
        takeWord(one);  // .param
        const Declaration parameter = declarationIn(one);
        kernel.parameters.push_back({parameter.name, parameter.placeBehind(kernel.parameterBytes), parameter.bytes});
    }
    const int line = 1 + int(std::count(all.begin(), all.begin() + std::ptrdiff_t(body), '\n'));
    BodyReader(kernel, all, body, line).read();
    return kernel;
}

}  // namespace pdr::ptx
