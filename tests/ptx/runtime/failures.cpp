#include "tests/ptx/runtime/failures.h"

#include <cctype>
#include <sstream>
#include <vector>

#include "tests/ptx/base/findings.h"

namespace pdr::ptx {

namespace {

u64 numberIn(const std::string& text) {
    if (text.empty() || text.find_first_not_of("0123456789") != text.npos)
        throw NotKnown("PDR_PTX_FAIL has no number where it must: " + text);
    return std::stoull(text);
}

}  // namespace

Failures::Failures(const std::string& wanted) {
    std::vector<std::string> parts;
    std::istringstream text(wanted);
    for (std::string part; std::getline(text, part, ':');)
        parts.push_back(part);
    if (parts.empty())
        return;
    if (std::isalpha(static_cast<unsigned char>(parts[0][0])) != 0) {
        call_ = parts[0];
        parts.erase(parts.begin());
    }
    number_ = numberIn(parts.empty() ? "" : parts[0]);
    if (parts.size() > 1)
        error_ = cudaError_t(numberIn(parts[1]));
}

cudaError_t Failures::next(const std::string& call) {
    const u64 ofName = ++byName_[call];
    ++all_;
    const bool isIt = call_.empty() ? number_ == all_ : call_ == call && number_ == ofName;
    return isIt && number_ > 0 ? error_ : cudaSuccess;
}

}  // namespace pdr::ptx
