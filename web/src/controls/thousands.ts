/** "67108864 words" → "67,108,864 words": the core writes numbers bare, for whoever reads them by program. */
export function withThousands(text: string): string {
	return text.replace(/(?<![\d.,])\d{5,}(?![\d.])/g, (digits) => Number(digits).toLocaleString("en-GB"));
}
