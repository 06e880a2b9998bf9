// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/legible.h"
#include "tests/gui/room_states.h"
#include "views/action_button.h"

using namespace cradle;
using namespace cradle::windows;

namespace {

/// Run and Check, if they have no room for their names.
QStringList iconsAlone(const TransportBar &bar)
{
    QStringList found;
    for (const ActionButton *button : bar.findChildren<ActionButton *>()) {
        const QString name = button->accessibleName();
        const bool isMain = name == bar.runAction()->text() || name == bar.checkAction()->text();
        if (isMain && button->text().isEmpty())
            found << QStringLiteral("%1 is an icon alone").arg(name);
    }
    return found;
}

} // namespace

/// Whatever the window says in whatever state can be read: it is whole, and stands alone on a
/// ground that it can be told from.
class TestLegibleTexts final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_room = std::make_unique<StatefulRoom>(m_folder);
    }
    void cleanupTestCase() { m_room.reset(); }
    void everyTextCanBeRead_data() { addStates(roomStates()); }
    void everyTextCanBeRead();

private:
    QTemporaryDir m_folder;
    std::unique_ptr<StatefulRoom> m_room;
};

void TestLegibleTexts::everyTextCanBeRead()
{
    QFETCH(RoomState, state);
    m_room->take(state);
    QStringList found;
    for (int turn = 0; turn < StatefulRoom::turns; ++turn) {
        m_room->showBehind(turn);
        found += illegibleTexts(m_room->window(), 61);
    }
    found.removeDuplicates();
    const auto *check =
        m_room->open().button(m_room->window().transportBar().checkAction()->text());
    QVERIFY(check && check->visibleRegion().boundingRect() == check->rect());
    found += iconsAlone(m_room->window().transportBar());
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestLegibleTexts)

#include "test_legible_texts.moc"
