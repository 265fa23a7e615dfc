/** Measures that go beyond the rules of axe-core: sizes of text and targets, clipped text, the outline of headings. */
import type { Page } from "@playwright/test";

/** Text spacing that a reader may set (WCAG 1.4.12). */
const TEXT_SPACING =
	"* { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important; } p { margin-bottom: 2em !important; }";

/** Defines `window.measures`, which walks the page with its open shadow trees. */
export function defineMeasures(): void {
	const visit = (root: Document | ShadowRoot | Element, each: (element: Element) => void): void => {
		for (const element of root.querySelectorAll("*")) {
			each(element);
			if (element.shadowRoot) visit(element.shadowRoot, each);
		}
	};
	const visible = (element: Element) => element.checkVisibility({ opacityProperty: true, visibilityProperty: true });
	const unseen = (element: Element): boolean => {
		for (let at: Element | null = element; at; at = at.parentElement) {
			if (getComputedStyle(at).clipPath === "inset(50%)") return true;
		}
		return false;
	};
	const inModal = (element: Element): boolean => {
		const modal = document.querySelector("dialog:modal");
		if (!modal) return true;
		for (let at: Node | null = element; at; at = at.parentNode ?? (at as ShadowRoot).host ?? null)
			if (at === modal) return true;
		return false;
	};
	const name = (element: Element) => {
		const words = (element.getAttribute("aria-label") ?? element.textContent ?? "").trim().replace(/\s+/g, " ");
		return `${element.localName}${element.className && typeof element.className === "string" ? `.${element.className.trim().split(/\s+/).join(".")}` : ""} “${words.slice(0, 40)}”`;
	};
	const ownText = (element: Element) =>
		[...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && (node.textContent ?? "").trim() !== "");
	const all = (keep: (element: Element) => boolean): Element[] => {
		const found: Element[] = [];
		visit(document, (element) => {
			if (visible(element) && !unseen(element) && inModal(element) && keep(element)) found.push(element);
		});
		return found;
	};
	const outline = () => {
		const found: Element[] = [];
		visit(document, (element) => {
			if (element.matches("h1, h2, h3, h4, h5, h6") && visible(element) && inModal(element)) found.push(element);
		});
		return found;
	};
	const parentOf = (element: Element): Element | null =>
		element.parentElement ?? (element.getRootNode() as Partial<ShadowRoot>).host ?? null;
	/** Whether a part of the element's own text is outside an ancestor that hides what overflows. */
	const isClipped = (element: Element): boolean => {
		const range = document.createRange();
		const boxes = [...element.childNodes]
			.filter((node) => node.nodeType === Node.TEXT_NODE && (node.textContent ?? "").trim() !== "")
			.flatMap((node) => {
				range.selectNodeContents(node);
				return [...range.getClientRects()];
			});
		let [sideways, upright] = [true, true];
		for (let at: Element | null = element; at && (sideways || upright); at = parentOf(at)) {
			const { overflowX, overflowY, position } = getComputedStyle(at);
			if (overflowX === "auto" || overflowX === "scroll") sideways = false;
			if (overflowY === "auto" || overflowY === "scroll") upright = false;
			const hides = (value: string) => value === "hidden" || value === "clip";
			const { left, right, top, bottom } = at.getBoundingClientRect();
			const outside = boxes.some(
				(box) =>
					(sideways && hides(overflowX) && (box.left < left - 2 || box.right > right + 2)) ||
					(upright && hides(overflowY) && (box.top < top - 4 || box.bottom > bottom + 4)),
			);
			if (outside) return true;
			if (position === "fixed") break;
		}
		return false;
	};
	const drawing = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", {
		willReadFrequently: true,
	}) as CanvasRenderingContext2D;
	/** Relative luminance of colours that are painted over each other, the lowest first (WCAG 2.2). */
	const luminance = (colours: readonly string[]): number => {
		for (const colour of colours) {
			drawing.fillStyle = colour;
			drawing.fillRect(0, 0, 1, 1);
		}
		const [r, g, b] = [...drawing.getImageData(0, 0, 1, 1).data]
			.map((value) => value / 255)
			.map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
		return 0.2126 * r + 0.7152 * g + 0.0722 * b;
	};
	/** Colours of the backgrounds below an element, the lowest first. */
	const grounds = (element: Element | null): string[] => {
		const found: string[] = ["white"];
		for (let at = element; at; at = parentOf(at)) found.splice(1, 0, getComputedStyle(at).backgroundColor);
		return found;
	};
	/** Contrast of a control's border, or of its fill if that is stronger, with what is around it. */
	const borderContrast = (element: Element): number => {
		const around = grounds(parentOf(element));
		const { borderTopColor, backgroundColor } = getComputedStyle(element);
		const ground = luminance(around);
		const ratios = [borderTopColor, backgroundColor].map((colour) => {
			const [low, high] = [luminance([...around, colour]), ground].sort((one, other) => one - other);
			return (high + 0.05) / (low + 0.05);
		});
		return Math.max(...ratios);
	};
	const isDisabled = (element: Element) => element.matches(":disabled, [aria-disabled=true]");
	const hasBorder = (element: Element): boolean => {
		const { borderTopWidth, borderTopStyle, borderTopColor } = getComputedStyle(element);
		return borderTopStyle === "solid" && Number.parseFloat(borderTopWidth) > 0 && borderTopColor !== "rgba(0, 0, 0, 0)";
	};
	const scaleOf = (element: Element) => (element instanceof SVGGraphicsElement ? (element.getScreenCTM()?.a ?? 1) : 1);
	Object.assign(window, {
		measures: {
			smallTexts: (least: number) =>
				all((element) => ownText(element) && !element.closest("style, script, option"))
					.map((element) => ({
						element,
						size: Number.parseFloat(getComputedStyle(element).fontSize) * scaleOf(element),
					}))
					.filter(({ size }) => size < least - 0.01)
					.map(({ element, size }) => `${size.toFixed(1)} px: ${name(element)}`),
			smallTargets: (least: number) =>
				all((element) =>
					element.matches(
						"button, summary, a[href], input:not([type=hidden], [hidden]), select, textarea, [role=slider], [role=menuitem]",
					),
				)
					.filter((element) => !(element.matches("a") && getComputedStyle(element).display === "inline"))
					.map((element) => {
						const box = (element.closest("label") ?? element).getBoundingClientRect();
						const own = element.getBoundingClientRect();
						return { element, size: [Math.max(box.width, own.width), Math.max(box.height, own.height)] };
					})
					.filter(({ size }) => Math.min(...size) < least - 0.05 && size[0] > 0)
					.map(({ element, size }) => `${size.map((side) => side.toFixed(1)).join(" × ")}: ${name(element)}`),
			clipped: () =>
				all((element) => ownText(element))
					.filter((element) => isClipped(element))
					.map((element) => name(element)),
			weakBorders: (least: number) =>
				all(
					(element) =>
						element.matches(
							"button, input:not([type=range], [type=checkbox], [type=radio]), select, textarea, .button",
						) &&
						hasBorder(element) &&
						!isDisabled(element),
				)
					.map((element) => ({ element, ratio: borderContrast(element) }))
					.filter(({ ratio }) => ratio < least - 0.05)
					.map(({ element, ratio }) => `${ratio.toFixed(2)}: ${name(element)}`),
			movingParts: (longest: number) =>
				all((element) => {
					const { transitionDuration, animationDuration, animationName, scrollBehavior } = getComputedStyle(element);
					const seconds = (times: string) => Math.max(...times.split(", ").map((each) => Number.parseFloat(each)));
					return (
						seconds(transitionDuration) > longest ||
						(animationName !== "none" && seconds(animationDuration) > longest) ||
						scrollBehavior === "smooth"
					);
				}).map((element) => name(element)),
			headings: () => outline().map((element) => `${element.localName} ${(element.textContent ?? "").trim()}`),
		},
	});
}

interface Measures {
	smallTexts(least: number): string[];
	smallTargets(least: number): string[];
	clipped(): string[];
	weakBorders(least: number): string[];
	movingParts(longest: number): string[];
	headings(): string[];
}

const inPage = <T>(page: Page, run: (measures: Measures) => T): Promise<T> =>
	page.evaluate(`(${run})(window.measures)`) as Promise<T>;
export const smallTexts = (page: Page) => inPage(page, (measures) => measures.smallTexts(12));
export const smallTargets = (page: Page) => inPage(page, (measures) => measures.smallTargets(24));
export const clippedTexts = (page: Page) => inPage(page, (measures) => measures.clipped());
/** Controls whose border has a contrast below 4.5 to 1: "2.98: button.button “Share”". */
export const weakBorders = (page: Page) => inPage(page, (measures) => measures.weakBorders(4.5));
/** Elements with transitions or animations that last longer than 0.01 s, or that scroll smoothly. */
export const movingParts = (page: Page) => inPage(page, (measures) => measures.movingParts(0.01));
export const headings = (page: Page) => inPage(page, (measures) => measures.headings());

/** Levels that a heading skips below the one before it: "h2 Size → h4 Height". */
export function skippedLevels(outline: readonly string[]): string[] {
	const level = (heading: string | undefined) => Number(heading?.slice(1, 2) ?? 0);
	return outline.flatMap((heading, index) =>
		index > 0 && level(heading) > level(outline[index - 1]) + 1 ? [`${outline[index - 1]} → ${heading}`] : [],
	);
}

/** Sets wide spacing of text in the page and in its open shadow trees, or removes it. */
export const setTextSpacing = (page: Page, on: boolean): Promise<void> =>
	page.evaluate(
		([css, spaced]) => {
			const sheet = new CSSStyleSheet();
			sheet.replaceSync(css);
			Object.assign(sheet, { spacing: true });
			const roots: (Document | ShadowRoot)[] = [document];
			for (const { shadowRoot } of document.querySelectorAll("*")) if (shadowRoot) roots.push(shadowRoot);
			for (const root of roots) {
				const others = root.adoptedStyleSheets.filter((each) => !("spacing" in each));
				root.adoptedStyleSheets = spaced ? [...others, sheet] : others;
			}
		},
		[TEXT_SPACING, on] as const,
	);
