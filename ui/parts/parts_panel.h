#pragma once
/// The parts of the scan: where they come from, the list of them, and how each is shown. Setters emit no signals.

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <vector>

#include "render/scene/part_styles.h"
#include "ui/parts/part_row.h"

namespace pdr::ui {

class PartsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit PartsPanel(QWidget* parent = nullptr);

    /// Sets the parts; the first row is the rest of the body. None: the scan has no parts.
    void setRows(const std::vector<PartRow>& rows);
    /// Sets what is to be known of the parts, in sentences.
    void setNotes(const QString& sentences);
    /// Sets the names of the looks whose curve a part can have.
    void setLooks(const QStringList& names);
    /// Sets whether something is being read or found, so that nothing else can be begun.
    void setBusy(bool busy);
    /// Whether parts are coloured on the slices.
    bool tints() const { return tinted_.isChecked(); }
    /// The rows that are selected, in ascending order.
    std::vector<int> selected() const;

    QSize sizeHint() const override { return {316, 420}; }

  signals:
    void labelFileWanted();
    void labelFolderWanted();
    void vesselsWanted();
    void shellsWanted();
    void mirrorWanted();
    void implantsWanted();
    void removeWanted();
    void tintChosen(bool tinted);
    /// `rows`: the numbers of rows in the list.
    void stateChosen(const std::vector<int>& rows, pdr::PartState state);
    void colourChosen(const std::vector<int>& rows, const QColor& colour);
    /// `look`: place in the list of setLooks(); -1: none, as all tissue is shown.
    void lookChosen(const std::vector<int>& rows, int look);

  private:
    QLayout* sourceButtons();
    QLayout* styleButtons();
    void chooseColour();
    void showSelection();

    QPushButton file_, folder_, vessels_, shells_, mirror_, implants_, remove_;
    QTreeWidget list_;
    QPushButton shown_, ghost_, hidden_, colour_;
    QToolButton look_;
    QMenu looks_;
    QCheckBox tinted_;
    QLabel notes_;
    std::vector<PartRow> rows_;
};

}  // namespace pdr::ui
