#pragma once
/// The gallery of looks, in groups that can be collapsed; each look has a thumbnail of this patient. Setters emit no
/// signals.

#include <QButtonGroup>
#include <QHash>
#include <QImage>
#include <QList>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

namespace pdr::ui {

/// The texts of one look.
struct LookCard {
    QString name;
    QString group;        ///< heading of its group
    QString doesNotShow;  ///< what the look does not show, in a sentence or two
    QString unsuited;     ///< why the look does not suit this scan: a clause; empty: it does
    bool own = false;     ///< saved by the user
    bool operator==(const LookCard&) const = default;
};

class LookGallery : public QWidget {
    Q_OBJECT

  public:
    /// Edge length of a thumbnail [px].
    static constexpr int kImage = 96;

    explicit LookGallery(QWidget* parent = nullptr);

    /// Sets the looks. Those that do not suit this scan come last, under a heading of their own. Groups stay expanded
    /// or collapsed, and looks that remain keep their thumbnails. No other group expands until setLook().
    void setLooks(const QList<LookCard>& looks);
    const QList<LookCard>& looks() const { return looks_; }
    /// Sets the widget before the first look in the Tab order, and those after the last, in that order.
    void setNeighbours(QWidget* leader, const QList<QWidget*>& followers) {
        leader_ = leader;
        followers_ = followers;
    }
    /// Marks the current look and expands its group, unless the user has collapsed it. -1: none of the looks is shown.
    void setLook(int index);
    /// Sets the thumbnail of a look. A null image: none yet.
    void setImage(int index, const QImage& image);

  signals:
    void lookChosen(int index);
    /// Emitted when the user expands a group. `group` holds its thumbnails.
    void unfolded(QWidget* group);

  private:
    struct Group {
        QToolButton* heading;
        QWidget* body;
    };

    void clear();
    Group& groupOf(const QString& name);
    void addCard(int index);
    void orderTabs();
    void unfold(const QString& group, bool open);

    QList<LookCard> looks_;
    QWidget* leader_ = nullptr;
    QList<QWidget*> followers_;
    QVBoxLayout* column_;
    QButtonGroup buttons_;
    QHash<QString, Group> groups_;
    QHash<QString, bool> open_;  ///< groups expanded (true) or collapsed by the user, by heading
};

}  // namespace pdr::ui
