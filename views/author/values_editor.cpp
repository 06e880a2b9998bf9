// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/values_editor.h"

#include "tasks/values/lab_values.h"
#include "views/author/form_rows.h"
#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/choice_box.h"
#include "views/on_change.h"

#include <QFormLayout>
#include <QLabel>
#include <QToolButton>

namespace cradle {

namespace {

constexpr int valuesWidth = 260;  ///< px
constexpr int longestDraw = 200;  ///< characters, as in lab.schema.json
constexpr int longestNumber = 64; ///< characters of a student's number
constexpr int longestValue = 400; ///< characters, as in the schemas
constexpr int mostValues = 50;    ///< as in the schemas
constexpr int mostShown = 12;     ///< numbers that a text lists

} // namespace

const FormLine<ValueForm> ValuesEditor::lines[LineCount] = {
    {"valueName", &ValueForm::name},
    {"valueExpression", &ValueForm::expression},
    {"valueFrom", nullptr, &ValueForm::from},
    {"valueTo", nullptr, &ValueForm::to},
    {"valueStep", nullptr, &ValueForm::step}};

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
    m_list = new RowsList(QStringLiteral("values"), side, {RowsList::Add, RowsList::Remove});
    m_list->wrapRows();
    side->setLayout(m_list->underHeading());
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
    QFormLayout *rows = makeFormRows();
    makeLines(lines, m_lines, m_form);
    for (QLineEdit *line : m_lines) {
        line->setMaxLength(longestValue);
        addField(rows, line);
        if (line == m_lines[Name])
            m_kind = addBox(rows, QStringLiteral("valueKind"));
    }
    m_place = addBox(rows, QStringLiteral("valuePlace"));
    setTabOrder(m_lines[Name], m_kind);
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
    m_list->setTexts(
        tr("Values of the lab and of the step"),
        {{RowsList::Add, tr("Add a value")}, {RowsList::Remove, tr("Remove the value")}},
        tr("Values · %1"));
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

void ValuesEditor::wire()
{
    connect(m_list, &RowsList::currentRowChanged, this, [this] {
        m_chosen = at() < 0 ? QString() : subjectOf(current());
        ++m_typing;
        showCurrent();
    });
    connect(m_list, &RowsList::addRequested, this, &ValuesEditor::add);
    connect(m_list, &RowsList::removeRequested, this, &ValuesEditor::remove);
    connect(m_list, &RowsList::renameRequested, this, &ValuesEditor::writeName);
    connect(m_kind, &QComboBox::activated, this, &ValuesEditor::takeKind);
    connect(m_place, &QComboBox::activated, this, &ValuesEditor::takePlace);
    connect(m_draw, &QLineEdit::textEdited, this, &ValuesEditor::takeDraw);
    connect(m_student, &QLineEdit::textChanged, this, &ValuesEditor::showFacts);
    for (int i = 0; i < LineCount; ++i)
        connect(m_lines[i], &QLineEdit::textEdited, this,
                [this, i] { takeLines(static_cast<Line>(i)); });
    connect(&m_document, &AuthorDocument::opened, this, [this] {
        m_texts.clear();
        m_student->clear();
    });
}

int ValuesEditor::at() const
{
    return m_list->currentRow();
}

QString ValuesEditor::subjectOf(const Row &row)
{
    return row.step.isEmpty() ? row.value.name : row.step + QLatin1Char('/') + row.value.name;
}

QStringList ValuesEditor::refused() const
{
    return m_texts.subjects();
}

void ValuesEditor::reload()
{
    m_rows.clear();
    for (const QString &step : {QString(), m_document.step()}) {
        if (step.isEmpty() && !m_rows.empty())
            continue; // no step is open
        for (const ValueForm &value : valueForms(m_document.files(), step))
            m_rows.push_back({step, value});
    }
    QStringList rows;
    int chosen = 0;
    for (const Row &row : m_rows) {
        if (subjectOf(row) == m_chosen)
            chosen = static_cast<int>(rows.size());
        rows.append(rowText(row));
    }
    m_list->showRows(rows, chosen);
    m_chosen = at() < 0 ? QString() : subjectOf(current());
    if (const QString draw = drawOf(m_document.files()); m_draw->text() != draw)
        m_draw->setText(draw);
    showCurrent();
}

void ValuesEditor::showValue(const QString &step, const QString &name)
{
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].step == step && m_rows[i].value.name == name)
            m_list->setCurrentRow(static_cast<int>(i));
    }
    m_lines[Name]->setFocus();
}

QString ValuesEditor::rowText(const Row &row) const
{
    const ValueForm &value = row.value;
    const QString what =
        value.drawn ? tr("%1: from %2 to %3, drawn")
                          .arg(value.name, shortestNumber(value.from), shortestNumber(value.to))
                    : QStringLiteral("%1 = %2").arg(value.name, value.expression);
    return row.step.isEmpty() ? tr("%1 (whole lab)").arg(what) : what;
}

void ValuesEditor::showCurrent()
{
    const bool writable = !m_document.isReadOnly();
    const bool any = at() >= 0;
    m_empty->setVisible(!any);
    m_form->setVisible(any);
    m_list->enableButtons(writable);
    m_list->button(RowsList::Add)
        ->setEnabled(writable && !m_document.steps().isEmpty()
                     && taken(m_document.step()).size() < mostValues);
    m_kind->setEnabled(writable);
    m_place->setEnabled(writable);
    m_draw->setReadOnly(!writable);
    for (QLineEdit *line : m_lines)
        line->setReadOnly(!writable);
    if (any) {
        m_texts.setSubject(m_chosen);
        m_kind->setCurrentIndex(current().value.drawn ? 1 : 0);
        m_place->setCurrentIndex(current().step.isEmpty() ? 0 : 1);
        showLines();
    }
    showFacts();
}

bool ValuesEditor::isShown(Line line) const
{
    return line == Name || (line == Expression) != current().value.drawn;
}

void ValuesEditor::showLines()
{
    for (int i = 0; i < LineCount; ++i) {
        m_texts.show(m_lines[i], lines[i].textIn(current().value), lines[i].number);
        showField(m_lines[i], isShown(static_cast<Line>(i)));
    }
    const QString reason = m_texts.reason();
    showRefusal(m_refusal, reason.isEmpty() ? faultOfValue(m_document.files(), current().step,
                                                           current().value.name)
                                            : reason);
}

/// What the value is for whom, and where it is used.
void ValuesEditor::showFacts()
{
    const bool any = at() >= 0;
    const bool drawn = any && current().value.drawn;
    m_facts->setVisible(any);
    showField(m_student, drawn);
    m_drawn->setVisible(drawn && !m_student->text().trimmed().isEmpty());
    showField(m_draw, drawsValues(m_document.files()));
    if (!any)
        return;
    const Row &row = current();
    const QString &name = row.value.name;
    QStringList facts{tr("Write {{%1}} in texts, programs and checks; in scenes and other values "
                         "%1 alone.")
                          .arg(name)};
    const Values values = valuesOf(m_document.files(), row.step, {});
    if (drawn) {
        QStringList numbers;
        for (const double number : numbersOf(row.value, mostShown))
            numbers.append(shortestNumber(number));
        const int count = countOf(row.value);
        if (count > mostShown)
            numbers.append(QStringLiteral("…"));
        facts.append(tr("Each student gets one of %n number(s): %1. You, and who gives no number, "
                        "have the first.",
                        nullptr, count)
                         .arg(numbers.join(QStringLiteral(", "))));
    } else if (values.contains(name)) {
        facts.append(QStringLiteral("%1 = %2").arg(name, shortestNumber(values.value(name))));
    }
    const QStringList uses = filesUsing(m_document.files(), row.step, name);
    facts.append(uses.isEmpty() ? tr("Nothing uses it yet.")
                                : tr("Used in %1.").arg(uses.join(QStringLiteral(", "))));
    m_facts->setText(facts.join(QStringLiteral("\n\n")));
    if (const QString student = m_student->text().trimmed(); !student.isEmpty())
        m_drawn->setText(
            tr("Student %1 has %2 = %3")
                .arg(student, name,
                     shortestNumber(valuesOf(m_document.files(), row.step, student).value(name))));
}

} // namespace cradle
