#include "dicom/stack/copies.h"

#include <algorithm>
#include <set>

#include "dicom/read/byte_source.h"
#include "dicom/read/open_images.h"
#include "dicom/stack/stack_notes.h"

namespace pdr::dicom {

namespace {

using Headers = std::vector<const SliceHeader*>;

bool sameBytes(const NamedBytes& a, const NamedBytes& b) {
    constexpr std::uint64_t kPiece = 1 << 16;
    ByteSource left(a), right(b);
    if (!left.opened() || !right.opened() || left.size() != right.size())
        return false;
    std::vector<std::uint8_t> leftPart(kPiece), rightPart(kPiece);
    for (std::uint64_t at = 0; at < left.size(); at += kPiece) {
        const std::uint64_t count = std::min(kPiece, left.size() - at);
        leftPart.resize(count);
        rightPart.resize(count);
        if (!left.read(at, leftPart) || !right.read(at, rightPart) || leftPart != rightPart)
            return false;
    }
    return true;
}

/// Compares images of a source at the same place.
class ImageComparison {
  public:
    explicit ImageComparison(const SeriesSource& source) : source_(source), images_(source) {}

    bool areSame(const SliceHeader& a, const SliceHeader& b) {
        if (a.frames == 1 && b.frames == 1) {
            const auto first = source_.open(a.file), second = source_.open(b.file);
            if (first && second && sameBytes(*first, *second))
                return true;
        }
        const auto left = images_.decode(a.file, a.frame, Padding::keep);
        const auto right = images_.decode(b.file, b.frame, Padding::keep);
        return left && right && left->hu == right->hu;
    }

  private:
    const SeriesSource& source_;
    OpenImages images_;
};

/// Returns the slices that repeat another one; empty as soon as there is one conflict, or the user cancels.
std::set<int> copiesAmong(const Headers& headers, const StackAnalysis& analysis, const SeriesSource& source,
                          const Progress& progress) {
    std::set<int> copies;
    ImageComparison images(source);
    for (const auto& [first, other] : analysis.samePlace) {
        const double done = double(copies.size()) / double(analysis.samePlace.size());
        if (!progress(done, "comparing slices at the same place") || !images.areSame(*headers[first], *headers[other]))
            return {};
        copies.insert(other);
    }
    return copies;
}

}  // namespace

StackAnalysis analyseWithoutCopies(Headers& headers, const SeriesSource& source, const Progress& progress) {
    const std::filesystem::path root = source.root();
    StackAnalysis analysis = analyseStack(planesOf(headers, root));
    const std::set<int> copies = copiesAmong(headers, analysis, source, progress);
    if (copies.empty())
        return analysis;
    std::vector<std::string> names;
    Headers kept;
    for (int i = 0; i < int(headers.size()); ++i) {
        if (copies.contains(i))
            names.push_back(sliceName(*headers[i], root));
        else
            kept.push_back(headers[i]);
    }
    headers = kept;
    analysis = analyseStack(planesOf(headers, root));
    analysis.verdict.notes.push_back(
        {"copies", phrase(copies.size() == 1 ? "1 copy of a slice left out (%2)" : "%1 copies of slices left out (%2)",
                          copies.size(), listed(names))});
    return analysis;
}

}  // namespace pdr::dicom
