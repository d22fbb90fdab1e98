#pragma once
/// Edits of how the parts of the scan are shown, as edits of the document. Parts of one name change together.

#include <QObject>
#include <optional>
#include <vector>

#include "app/document/document.h"
#include "render/scene/part_styles.h"

namespace pdr::app {

/// Numbers of parts: 0 is the rest of the body, n is part n - 1 of the label map.
using PartNumbers = std::vector<int>;

class PartEdits : public QObject {
    Q_OBJECT

  public:
    /// `document` must outlive this object.
    explicit PartEdits(Document& document) : document_(document) {}

  public slots:
    /// Each is one step to undo.
    void setState(const std::vector<int>& parts, pdr::PartState state);
    /// None: the colours of the curve. The rest of the body has no colour of its own.
    void setColour(const std::vector<int>& parts, const std::optional<pdr::vec3>& albedo);
    /// Takes the curve of look `index` of the document's looks; -1: that of all tissue, and its colours.
    void setLook(const std::vector<int>& parts, int index);

  private:
    template <class Change>
    PartStyles changed(const PartNumbers& parts, const Change& change) const;
    void set(PartStyles styles);

    Document& document_;
};

}  // namespace pdr::app
