#include "ui/text/series_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace pdr::ui {
namespace {

struct NoteWord {
    const char* code;  ///< dicom::Note::code
    const char* word;
};

/// Notes with a word of their own, the gravest first: values of another quantity, values that were not measured, then
/// slices that are not there, then where the slices lie, then what the values mean. A question mark stands where the
/// note says "may".
constexpr NoteWord kNoteWords[] = {
    {"no-hu", QT_TRANSLATE_NOOP("series", "no HU")},
    {"resampled", QT_TRANSLATE_NOOP("series", "resampled")},
    {"lossy", QT_TRANSLATE_NOOP("series", "lossy")},
    {"maybe-lossy", QT_TRANSLATE_NOOP("series", "lossy?")},
    {"clipped", QT_TRANSLATE_NOOP("series", "clipped")},
    {"damaged", QT_TRANSLATE_NOOP("series", "incomplete")},
    {"incomplete", QT_TRANSLATE_NOOP("series", "incomplete?")},
    {"unread", QT_TRANSLATE_NOOP("series", "incomplete?")},
    {"parts", QT_TRANSLATE_NOOP("series", "divided")},
    {"tilt", QT_TRANSLATE_NOOP("series", "tilted")},
    {"uneven", QT_TRANSLATE_NOOP("series", "uneven")},
    {"grid", QT_TRANSLATE_NOOP("series", "uneven")},
    {"modality", QT_TRANSLATE_NOOP("series", "modality")},
    {"rescale", QT_TRANSLATE_NOOP("series", "units")},
    {"rounded", QT_TRANSLATE_NOOP("series", "rounded")},
    {"copies", QT_TRANSLATE_NOOP("series", "copies")},
    {"mended", QT_TRANSLATE_NOOP("series", "mended")},
};

const char* stackWord(dicom::Stack stack) {
    using dicom::Stack;
    switch (stack) {
        case Stack::even:
            return QT_TRANSLATE_NOOP("series", "can be shown");
        case Stack::singleSlice:
            return QT_TRANSLATE_NOOP("series", "a single slice");
        case Stack::gap:
            return QT_TRANSLATE_NOOP("series", "a slice is missing");
        case Stack::doubled:
            return QT_TRANSLATE_NOOP("series", "duplicate slice position");
        case Stack::tilted:
            return QT_TRANSLATE_NOOP("series", "slices not in line");
        case Stack::mixedOrientation:
            return QT_TRANSLATE_NOOP("series", "mixed slice orientations");
        case Stack::mixedSize:
            return QT_TRANSLATE_NOOP("series", "slices of different size");
        case Stack::noGeometry:
            return QT_TRANSLATE_NOOP("series", "missing position data");
        case Stack::notCt:
            return QT_TRANSLATE_NOOP("series", "not a CT volume");
        case Stack::unreadable:
            return QT_TRANSLATE_NOOP("series", "cannot be read");
    }
    return "";
}

}  // namespace

QString unusualWord(const std::vector<dicom::Note>& notes) {
    if (notes.empty())
        return {};
    const auto* word = std::ranges::find_if(
        kNoteWords, [&](const NoteWord& known) { return std::ranges::count(notes, known.code, &dicom::Note::code); });
    return QCoreApplication::translate("series",
                                       word == std::end(kNoteWords) ? QT_TRANSLATE_NOOP("series", "note") : word->word);
}

QString verdictText(const dicom::GeometryVerdict& verdict) {
    const QChar symbol(verdict.loadable() ? 0x2713 : 0x2717);
    const QString unusual = verdict.loadable() ? unusualWord(verdict.notes) : QString();
    return QString("%1  %2").arg(
        symbol, unusual.isEmpty() ? QCoreApplication::translate("series", stackWord(verdict.stack)) : unusual);
}

}  // namespace pdr::ui
