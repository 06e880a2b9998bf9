// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/values_editor.h"

#include "views/author/form_rows.h"
#include "views/author/item_texts.h"
#include "views/author/rows_list.h"
#include "views/on_change.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

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
    const auto addBox = [this](QFormLayout *rows, QLabel *&caption, QComboBox *&box,
                               const QString &name) {
        caption = new QLabel(m_form);
        box = new QComboBox(m_form);
        box->setObjectName(name);
        caption->setBuddy(box);
        rows->addRow(caption, box);
    };
    // Made in the order in which Tab reaches them.
    const char *const names[] = {"valueName", "valueExpression", "valueFrom", "valueTo",
                                 "valueStep"};
    QFormLayout *rows = makeFormRows();
    for (int i = 0; i < LineCount; ++i) {
        m_captions[i] = new QLabel(m_form);
        m_lines[i] = new QLineEdit(m_form);
        m_lines[i]->setObjectName(QLatin1String(names[i]));
        m_lines[i]->setMaxLength(longestValue);
        m_captions[i]->setBuddy(m_lines[i]);
        rows->addRow(m_captions[i], m_lines[i]);
        if (i == Name)
            addBox(rows, m_kindCaption, m_kind, QStringLiteral("valueKind"));
    }
    addBox(rows, m_placeCaption, m_place, QStringLiteral("valuePlace"));
    m_refusal = makeRefusal(m_form);
    m_refusal->setObjectName(QStringLiteral("valueRefusal"));
    auto *column = new QVBoxLayout(m_form);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addLayout(rows);
    column->addWidget(m_refusal);
    auto *both = new QVBoxLayout(side);
    both->setContentsMargins(12, 8, 12, 8);
    both->addWidget(m_empty);
    both->addWidget(m_form);
    both->addStretch(1);
    return side;
}

QWidget *ValuesEditor::makeFacts()
{
    auto *side = new QWidget;
    m_facts = makeMutedText(side);
    m_facts->setObjectName(QStringLiteral("valueFacts"));
    m_studentCaption = new QLabel(side);
    m_student = new QLineEdit(side);
    m_student->setObjectName(QStringLiteral("valueStudent"));
    m_student->setMaxLength(longestNumber);
    m_studentCaption->setBuddy(m_student);
    m_drawn = makeMutedText(side);
    m_drawn->setObjectName(QStringLiteral("valueDrawn"));
    m_drawCaption = new QLabel(side);
    m_draw = new QLineEdit(side);
    m_draw->setObjectName(QStringLiteral("valueDraw"));
    m_draw->setMaxLength(longestDraw);
    m_drawCaption->setBuddy(m_draw);
    QFormLayout *rows = makeFormRows();
    rows->addRow(m_studentCaption, m_student);
    rows->addRow(m_drawn);
    rows->addRow(m_drawCaption, m_draw);
    auto *column = new QVBoxLayout(side);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(12);
    column->addWidget(m_facts);
    column->addLayout(rows);
    column->addStretch(1);
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
    setItemTexts(*m_kind, {tr("The same for all"), tr("Drawn for each student")});
    setItemTexts(*m_place, {tr("In the whole lab"), tr("In this step")});
    m_kindCaption->setText(tr("Kind"));
    m_kind->setAccessibleName(tr("Whether the value is drawn"));
    m_placeCaption->setText(tr("Known"));
    m_place->setAccessibleName(tr("Where the value is known"));
    const QString captions[] = {tr("Name"), tr("Value"), tr("From"), tr("To"), tr("Step")};
    for (int i = 0; i < LineCount; ++i) {
        m_captions[i]->setText(captions[i]);
        m_lines[i]->setAccessibleName(captions[i]);
    }
    m_lines[Name]->setToolTip(tr("Letters, digits and underscores"));
    m_lines[Expression]->setToolTip(
        tr("A number, or an expression like 2*k or sqrt(2*9.81*5), in the unit that its uses "
           "want"));
    m_lines[Step]->setToolTip(tr("From one number to the next"));
    m_studentCaption->setText(tr("Student number"));
    m_student->setAccessibleName(tr("Student number to try the draw with"));
    m_student->setToolTip(tr("To see what that student gets; it is kept nowhere"));
    m_drawCaption->setText(tr("Draw"));
    m_draw->setAccessibleName(tr("Draw of the lab"));
    m_draw->setToolTip(tr("Another text draws other values: change it every year"));
}

} // namespace cradle
