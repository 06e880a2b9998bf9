// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/values_editor.h"

#include "views/author/form_rows.h"
#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/choice_box.h"
#include "views/on_change.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

namespace cradle {

namespace {

constexpr int valuesWidth = 260;  ///< px
constexpr int longestDraw = 200;  ///< characters, as in lab.schema.json
constexpr int longestNumber = 64; ///< characters of a student's number
constexpr int longestValue = 400; ///< characters, as in the schemas

} // namespace

ValuesEditor::ValuesEditor(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    layOutSideBySide(this, {makeList(), makeForm(), makeFacts()}, {valuesWidth, 370, 370});
    setFocusProxy(m_list);
    retranslate();
    wire();
    reload();
    onChange(this, {QEvent::LanguageChange}, [this] {
        retranslate();
        reload();
    });
}

QWidget *ValuesEditor::makeList()
{
    auto *side = new QWidget;
    m_heading = makeHeading(side);
    m_list = new RowsList(QStringLiteral("values"), side, {RowsList::Add, RowsList::Remove});
    m_list->wrapRows();
    side->setLayout(m_list->underHeading(m_heading));
    return side;
}

QWidget *ValuesEditor::makeForm()
{
    auto *side = new QWidget;
    m_empty = makeMutedText(side);
    m_form = new QWidget(side);
    const auto addBox = [this](QFormLayout *rows, const QString &name) {
        auto *box = new ChoiceBox(m_form);
        box->setObjectName(name);
        addField(rows, box);
        return box;
    };
    // Made in the order in which Tab reaches them.
    const char *const names[] = {"valueName", "valueExpression", "valueFrom", "valueTo",
                                 "valueStep"};
    QFormLayout *rows = makeFormRows();
    for (int i = 0; i < LineCount; ++i) {
        m_lines[i] = new QLineEdit(m_form);
        m_lines[i]->setObjectName(QLatin1String(names[i]));
        m_lines[i]->setMaxLength(longestValue);
        addField(rows, m_lines[i]);
        if (i == Name)
            m_kind = addBox(rows, QStringLiteral("valueKind"));
    }
    m_place = addBox(rows, QStringLiteral("valuePlace"));
    m_refusal = makeRefusal(m_form);
    m_refusal->setObjectName(QStringLiteral("valueRefusal"));
    layOutColumn(m_form, {}, 8, {rows, m_refusal});
    layOutColumn(side, {12, 8, 12, 8}, -1, {m_empty, m_form, BoxPart::rest()});
    return side;
}

QWidget *ValuesEditor::makeFacts()
{
    auto *side = new QWidget;
    m_facts = makeMutedText(side);
    m_facts->setObjectName(QStringLiteral("valueFacts"));
    m_student = new QLineEdit(side);
    m_student->setObjectName(QStringLiteral("valueStudent"));
    m_student->setMaxLength(longestNumber);
    m_drawn = makeMutedText(side);
    m_drawn->setObjectName(QStringLiteral("valueDrawn"));
    m_draw = new QLineEdit(side);
    m_draw->setObjectName(QStringLiteral("valueDraw"));
    m_draw->setMaxLength(longestDraw);
    QFormLayout *rows = makeFormRows();
    addField(rows, m_student);
    rows->addRow(m_drawn);
    addField(rows, m_draw);
    layOutColumn(side, {12, 8, 12, 8}, 12, {m_facts, rows, BoxPart::rest()});
    return side;
}

void ValuesEditor::retranslate()
{
    m_heading->setText(tr("Values · %1").arg(m_list->count()));
    m_list->setAccessibleName(tr("Values of the lab and of the step"));
    m_list->nameButton(RowsList::Add, tr("Add a value"));
    m_list->nameButton(RowsList::Remove, tr("Remove the value"));
    m_empty->setText(tr("No number has a name yet. Add one with the plus, and write it in braces, "
                        "as {{e}}, where texts, programs and checks need it: then it stands in one "
                        "place, and may be another for each student."));
    m_kind->setTexts({tr("The same for all"), tr("Drawn for each student")});
    m_place->setTexts({tr("In the whole lab"), tr("In this step")});
    nameField(m_kind, tr("Kind"), {}, tr("Whether the value is drawn"));
    nameField(m_place, tr("Known"), {}, tr("Where the value is known"));
    nameField(m_lines[Name], tr("Name"), tr("Letters, digits and underscores"));
    nameField(m_lines[Expression], tr("Value"),
              tr("A number, or an expression like 2*k or sqrt(2*9.81*5), in the unit that its "
                 "uses want"));
    nameField(m_lines[From], tr("From"));
    nameField(m_lines[To], tr("To"));
    nameField(m_lines[Step], tr("Step"), tr("From one number to the next"));
    nameField(m_student, tr("Student number"),
              tr("To see what that student gets; it is kept nowhere"),
              tr("Student number to try the draw with"));
    nameField(m_draw, tr("Draw"), tr("Another text draws other values: change it every year"),
              tr("Draw of the lab"));
}

} // namespace cradle
