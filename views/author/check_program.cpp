// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/check_program.h"

#include "tasks/authoring/free_name.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/checks/check_kinds.h"
#include "tasks/script/student_script.h"
#include "views/boxes.h"
#include "views/code/code_editor.h"
#include "views/on_change.h"

namespace cradle {

namespace {

QString pathIn(const QString &step, const QString &file)
{
    return QStringLiteral("%1/checks/%2").arg(step, file);
}

} // namespace

CheckProgram::CheckProgram(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_editor(new CodeEditor(this))
{
    layOutColumn(this, {}, -1, {m_editor});
    keepTranslated(this, &CheckProgram::retranslate);
    connect(m_editor, &CodeEditor::textEdited, this, &CheckProgram::takeText);
}

QString CheckProgram::fileOf(const CheckForm &check)
{
    const std::vector<KindInfo> kinds = checkKinds();
    const KindInfo *kind = findKind(kinds, check.kind);
    if (!kind)
        return {};
    for (const ParameterInfo &info : kind->parameters) {
        const QString name = check.parameters.value(info.name).toString();
        if (info.type == ParameterInfo::Type::Script && !name.isEmpty())
            return name.endsWith(QLatin1String(".lua")) ? name : name + QStringLiteral(".lua");
    }
    return {};
}

void CheckProgram::showCheck(const CheckForm &check)
{
    const QString file = fileOf(check);
    setVisible(!file.isEmpty());
    if (file.isEmpty())
        return;
    const QString path = pathIn(m_document.step(), file);
    const QString text = textOf(m_document.files(), path);
    m_editor->setReadOnly(false); // a read-only area takes no text at all
    if (path != m_path)
        m_editor->setText(text);
    else
        m_editor->replaceText(text);
    m_editor->setReadOnly(m_document.isReadOnly());
    m_path = path;
    const auto error = findSyntaxError(text);
    if (error)
        m_editor->setError(error->line, error->message);
    else
        m_editor->clearError();
}

LabFiles CheckProgram::begin(const LabFiles &files, const QString &step, CheckForm &check)
{
    const QString name = check.id + QStringLiteral(".lua");
    check.parameters = {{QStringLiteral("script"), name}};
    const QString path = pathIn(step, name);
    if (files.contents.contains(path))
        return files;
    return withText(files, path,
                    tr("-- Returns true, or false and what is wrong.\n")
                        + QStringLiteral("function check(run)\n  return true\nend\n"));
}

LabFiles CheckProgram::copied(const LabFiles &files, const QString &step, CheckForm &check)
{
    const QString from = fileOf(check);
    if (from.isEmpty() || !files.contents.contains(pathIn(step, from)))
        return files;
    const QString name =
        freeName(check.id,
                 [&](const QString &each) {
                     return files.contents.contains(pathIn(step, each + QStringLiteral(".lua")));
                 })
        + QStringLiteral(".lua");
    check.parameters.insert(QStringLiteral("script"), name);
    return withFile(files, pathIn(step, name), files.contents.value(pathIn(step, from)));
}

void CheckProgram::takeText()
{
    m_document.edit(tr("Edit the program of a check"),
                    withText(m_document.files(), m_path, m_editor->text()),
                    QStringLiteral("script:") + m_path);
}

void CheckProgram::retranslate()
{
    m_editor->setAccessibleName(tr("Program of the check"));
}

} // namespace cradle
