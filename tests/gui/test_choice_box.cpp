// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/choice_box.h"

#include <QTest>

using namespace cradle;

class TestChoiceBox final : public QObject
{
    Q_OBJECT
private slots:
    /// As in another language.
    void isNoWiderThanWhatItSaysNow()
    {
        ChoiceBox box;
        box.addItems({QStringLiteral("Continuous, as long as it takes"), QStringLiteral("Exact")});
        const int before = box.minimumSizeHint().width();
        box.setItemText(0, QStringLiteral("Stetig"));
        QVERIFY(box.minimumSizeHint().width() < before);
        QCOMPARE(box.minimumSizeHint(), box.sizeHint());
    }
};

QTEST_MAIN(TestChoiceBox)

#include "test_choice_box.moc"
