// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Entry of the bundle: defines the global function texToSvg() and nothing else.

import {mathjax} from 'mathjax-full/js/mathjax.js';
import {TeX} from 'mathjax-full/js/input/tex.js';
import {SVG} from 'mathjax-full/js/output/svg.js';
import {SVGmo} from 'mathjax-full/js/output/svg/Wrappers/mo.js';
import {liteAdaptor} from 'mathjax-full/js/adaptors/liteAdaptor.js';
import {RegisterHTMLHandler} from 'mathjax-full/js/handlers/html.js';
import 'mathjax-full/js/input/tex/base/BaseConfiguration.js';
import 'mathjax-full/js/input/tex/ams/AmsConfiguration.js';
import 'mathjax-full/js/input/tex/boldsymbol/BoldsymbolConfiguration.js';
import 'mathjax-full/js/input/tex/cancel/CancelConfiguration.js';
import 'mathjax-full/js/input/tex/color/ColorConfiguration.js';

// Stretched brackets are built of pieces. MathJax clips the middle piece with a nested <svg>,
// which Qt's SVG Tiny renderer does not support, so here the piece is scaled to fit instead.
// The overlap, in em, hides the seams; it is MathJax's own value.
const OVERLAP = 0.1;

SVGmo.prototype.addExtV = function (n, v, H, D, T, B, W) {
    if (!n) return;
    const [h, d, w] = this.getChar(n, v);
    const bottom = Math.max(0, B - OVERLAP) - D;
    const length = H - Math.max(0, T - OVERLAP) - bottom;
    if (length <= 0) return;
    const scale = length / (h + d);
    this.adaptor.append(this.element, this.svg('g', {
        transform: `translate(${this.fixed((W - w) / 2)},${this.fixed(bottom + scale * d)}) ` +
            `scale(1,${scale.toFixed(4)})`,
    }));
    this.addGlyph(n, v, 0, 0, this.adaptor.lastChild(this.element));
};

SVGmo.prototype.addExtH = function (n, v, W, L, R, x = 0) {
    if (!n) return;
    const w = this.getChar(n, v)[2];
    const left = Math.max(0, L - OVERLAP);
    const length = W - left - Math.max(0, R - OVERLAP);
    if (length <= 0) return;
    this.adaptor.append(this.element, this.svg('g', {
        transform: `translate(${this.fixed(x + left)},0) scale(${(length / w).toFixed(4)},1)`,
    }));
    this.addGlyph(n, v, 0, 0, this.adaptor.lastChild(this.element));
};

const adaptor = liteAdaptor();
RegisterHTMLHandler(adaptor);

const page = mathjax.document('', {
    InputJax: new TeX({
        packages: ['base', 'ams', 'boldsymbol', 'cancel', 'color'],
        formatError: (_, error) => { throw error; },
    }),
    OutputJax: new SVG({fontCache: 'none'}),
});

// Qt's renderer takes no style sheet, so lines of tables get their width here, which is that of
// MathJax's own style sheet, in units of 1/1000 em. A \rule gets the colour of the text, not black.
const LINE_WIDTH = '70';

function styleLines(node) {
    for (const child of adaptor.childNodes(node)) {
        if (adaptor.kind(child) === '#text') continue;
        if (adaptor.hasAttribute(child, 'data-line') || adaptor.hasAttribute(child, 'data-frame')) {
            adaptor.setAttribute(child, 'stroke-width', LINE_WIDTH);
            adaptor.setAttribute(child, 'fill', 'none');
        }
        if (adaptor.getAttribute(node, 'data-mml-node') === 'mspace') {
            adaptor.setAttribute(child, 'fill', 'currentColor');
        }
        if (adaptor.hasClass(child, 'mjx-dashed')) {
            adaptor.setAttribute(child, 'stroke-dasharray', '140');
        }
        styleLines(child);
    }
}

function typeset(tex, display) {
    if (tex.trim() === '') throw new Error('The formula is empty');
    const svg = adaptor.firstChild(page.convert(tex, {display: !!display}));
    if (adaptor.getAttribute(svg, 'width').endsWith('%')) {
        throw new Error('Numbered equations (\\tag) are not supported');
    }
    styleLines(svg);
    const style = adaptor.getAttribute(svg, 'style') || '';
    const depth = /vertical-align:\s*(-?[\d.]+)/.exec(style);
    adaptor.removeAttribute(svg, 'style');
    return {
        svg: adaptor.outerHTML(svg),
        width_ex: parseFloat(adaptor.getAttribute(svg, 'width')),
        height_ex: parseFloat(adaptor.getAttribute(svg, 'height')),
        depth_ex: depth ? -parseFloat(depth[1]) : 0,
    };
}

// The JavaScript of Qt 6.4 has no globalThis.
const globals = new Function('return this')();

/**
 * Typesets one formula.
 * @param {string} tex      the formula without its dollars
 * @param {boolean} display own line (large operators and limits) instead of within text
 * @return {string} JSON: {svg, width_ex, height_ex, depth_ex}, with the whole height and the part
 *     of it below the baseline, where 1 ex is the height of an x; or {error} with the reason
 */
globals.texToSvg = function (tex, display) {
    try {
        return JSON.stringify(typeset(tex, display));
    } catch (error) {
        return JSON.stringify({error: error.message || String(error)});
    }
};
