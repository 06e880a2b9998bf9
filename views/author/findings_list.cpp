// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/findings_list.h"

#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QLabel>

#include <algorithm>

namespace cradle {

namespace {

constexpr int mostHeight = 150; ///< px

/// The path of \p finding below the lab's folder.
QString pathIn(const QString &folder, const Error &finding)
{
    if (folder.isEmpty())
        return finding.file.startsWith(QLatin1Char('/')) ? finding.file.mid(1) : finding.file;
    if (!finding.file.startsWith(folder + QLatin1Char('/')))
        return finding.file;
    return finding.file.mid(folder.size() + 1);
}

} // namespace

FindingsList::FindingsList(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_heading(makeHeading(this))
    , m_list(new RowsList(QStringLiteral("authorFindings"), this))
{
    m_heading->setContentsMargins(12, 8, 12, 4);
    m_list->wrapRows();
    m_list->setMaximumHeight(mostHeight);
    layOutColumn(this, {}, 0, {m_heading, m_list});
    connect(&document, &AuthorDocument::labRead, this, &FindingsList::reload);
    connect(m_list, &RowsList::chosen, this,
            [this](int row) { emit chosen(m_findings[static_cast<std::size_t>(row)]); });
    reload();
    onChange(this, {QEvent::LanguageChange}, [this] { retranslate(); });
    onChange(this, {QEvent::PaletteChange}, [this] { reload(); });
}

void FindingsList::reload()
{
    m_findings = m_document.unread();
    m_findings.insert(m_findings.end(), m_document.lab().findings.begin(),
                      m_document.lab().findings.end());
    m_list->clear();
    for (Error &finding : m_findings) {
        finding.file = pathIn(m_document.folder(), finding);
        auto *item = new QListWidgetItem(finding.toString());
        item->setForeground(theme().warning);
        item->setToolTip(finding.toString());
        m_list->addItem(item);
    }
    m_list->setVisible(!m_findings.empty());
    retranslate();
    emit shown();
}

bool FindingsList::concernsStep(const QString &step) const
{
    return std::any_of(m_findings.begin(), m_findings.end(), [&](const Error &finding) {
        return finding.file.startsWith(step + QLatin1Char('/'));
    });
}

void FindingsList::retranslate()
{
    const auto count = static_cast<int>(m_findings.size());
    m_heading->setText(count == 0 ? tr("All files can be read") : tr("Findings · %1").arg(count));
    m_list->setAccessibleName(tr("Findings in the lab's files"));
}

} // namespace cradle
