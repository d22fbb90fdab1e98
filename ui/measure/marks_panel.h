#pragma once
/// The list of all measurements, with their values, the buttons of the tools that measure, and the HU along a distance.
/// Setters emit no signals.

#include <QGridLayout>
#include <QToolButton>
#include <QTreeWidget>
#include <QWidget>
#include <cstdint>
#include <vector>

#include "ui/measure/profile_chart.h"

namespace pdr::ui {

/// A measurement in the list.
struct MarkRow {
    std::uint64_t id = 0;
    QString name;    ///< what the user calls it, or what it is: "Distance 2"
    QString value;   ///< "42.3 ± 0.5 mm"
    QString causes;  ///< what the ± consists of and does not; the tool tip
    bool operator==(const MarkRow&) const = default;
};

class MarksPanel : public QWidget {
    Q_OBJECT

  public:
    explicit MarksPanel(QWidget* parent = nullptr);

    /// Adds a button that shows and triggers `action`.
    void addTool(QAction* action);
    void setRows(const std::vector<MarkRow>& rows);
    void setSelected(std::uint64_t id);
    /// Sets the HU along the selected measurement; none: the list has the room.
    void setProfile(const std::optional<ShownProfile>& profile) { chart_.setProfile(profile); }
    /// Opens the name of a row for typing.
    void editName(std::uint64_t id);

    QSize sizeHint() const override { return {316, 260}; }

  signals:
    void selected(std::uint64_t id);
    void renamed(std::uint64_t id, const QString& name);
    void removed(std::uint64_t id);

  protected:
    bool eventFilter(QObject* list, QEvent* event) override;

  private:
    std::uint64_t idOf(const QTreeWidgetItem* item) const;
    QTreeWidgetItem* itemOf(std::uint64_t id) const;

    QGridLayout* buttons_;
    QToolButton remove_;
    QTreeWidget list_;
    ProfileChart chart_;
    std::vector<MarkRow> rows_;
};

}  // namespace pdr::ui
