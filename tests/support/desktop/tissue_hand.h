#pragma once
/// Pointer interaction with the tissue panel, and a record of what the panel emits.

#include <QTest>

#include "tests/support/desktop/mouse.h"
#include "ui/tissue/tissue_panel.h"

namespace pdr::ui {

inline TransferFunction bone() {
    TransferFunction function{1.2f, std::vector<TransferNode>(4)};
    const float hu[] = {-1000, 150, 400, 1500}, opacity[] = {0, 0, 0.8f, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        function.nodes[i].hu = hu[i];
        function.nodes[i].opacity = opacity[i];
        function.nodes[i].albedo = i < 2 ? vec3(0.8f, 0.1f, 0.1f) : vec3(0.9f, 0.9f, 0.7f);
    }
    return function;
}

/// The panel with a transfer function, and a record of what it emits.
struct TissueHand {
    TissueHand() {
        QObject::connect(&panel, &TissuePanel::transferFunctionEdited,
                         [this](const TransferFunction& function, bool moving) {
                             last = function;
                             edits += moving;
                             rests += !moving;
                             panel.setTransferFunction(function);  // as the document does
                         });
        panel.setTransferFunction(bone());
        panel.resize(320, 460);
        panel.show();
        emit panel.editor().fitRequested();
    }

    QPoint at(double hu, double value) { return panel.editor().view().at(hu, value).toPoint(); }

    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(&panel.editor(), Qt::LeftButton, keys, from);
        test::dragOn(panel.editor(), (from + to) / 2);
        test::dragOn(panel.editor(), to);
        QTest::mouseRelease(&panel.editor(), Qt::LeftButton, keys, to);
    }

    template <class Control>
    Control* named(const QString& name) {
        for (Control* control : panel.findChildren<Control*>())
            if (control->accessibleName() == name)
                return control;
        qFatal("there is no control %s", qPrintable(name));
    }

    void choose(const char* box, int index) {
        auto* combo = named<QComboBox>(box);
        combo->setCurrentIndex(index);
        emit combo->activated(index);
    }

    TissuePanel panel;
    TransferFunction last;
    int edits = 0, rests = 0;
};

}  // namespace pdr::ui
