// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/language_box.h"

#include "views/author/text_languages.h"
#include "views/on_change.h"

namespace cradle {

LanguageBox::LanguageBox(AuthorDocument &document, QWidget *parent)
    : ChoiceBox(parent)
    , m_document(document)
{
    setObjectName(QStringLiteral("textLanguage"));
    keepTranslated(this, &LanguageBox::retranslate);
    showLanguages();
    connect(&document, &AuthorDocument::changed, this, &LanguageBox::showLanguages);
    connect(&document, &AuthorDocument::languageChanged, this, &LanguageBox::showLanguages);
    connect(this, &QComboBox::activated, this,
            [this] { m_document.setLanguage(currentData().toString()); });
}

void LanguageBox::showLanguages()
{
    const QStringList codes = offeredLanguages(m_document.files());
    QStringList shown;
    for (int i = 0; i < count(); ++i)
        shown.append(itemData(i).toString());
    if (shown != codes) {
        clear();
        for (const QString &code : codes)
            addItem(tr("Texts in %1").arg(languageWithCode(code)), code);
    }
    setCurrentIndex(findData(m_document.language()));
}

void LanguageBox::retranslate()
{
    setAccessibleName(tr("Language of the texts"));
    setToolTip(tr("What is typed in any of the tabs, and the titles of steps, are in this "
                  "language"));
    QStringList texts;
    for (int i = 0; i < count(); ++i)
        texts.append(tr("Texts in %1").arg(languageWithCode(itemData(i).toString())));
    setTexts(texts);
}

} // namespace cradle
