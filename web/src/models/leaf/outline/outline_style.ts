import { css } from "lit";

/** Styles of the outline's view in addition to handle_style.ts. */
export const outlineStyle = css`
	:host {
		container-type: size;
	}
	.field {
		bottom: 40px;
	}
	.handle::before {
		width: 8px;
		height: 8px;
		border-width: 1.5px;
		background: var(--ground);
	}
	.handle[data-kind="corner"]::before {
		border-radius: 0;
	}
	.handle[data-kind="lobe"]::before,
	.handle[data-kind="pointed"]::before {
		width: 9px;
		height: 9px;
		background: var(--grip);
	}
	.handle[data-kind="pointed"]::before {
		width: 8px;
		height: 8px;
		border-radius: 0;
		rotate: 45deg;
	}
	.handle::after {
		width: 20px;
		height: 20px;
	}
	.handle.chosen::after {
		border: 1.25px solid color-mix(in srgb, var(--grip) 55%, transparent);
	}
	.handle:hover::before {
		scale: 1.3;
	}
	.handle.held::before {
		scale: 1.4;
		background: var(--grip);
	}
	.bar {
		position: absolute;
		inset: auto 0 0;
		display: flex;
		gap: 4px;
		height: 36px;
	}
	.bar button {
		flex: 1;
		min-width: 0;
		max-width: 56px;
		padding: 0;
		border: 1px solid color-mix(in srgb, currentColor 22%, transparent);
		border-radius: 6px;
		background: none;
		color: inherit;
		cursor: pointer;
	}
	.bar button:hover:not(:disabled) {
		border-color: var(--grip);
		color: var(--grip);
	}
	.bar button[aria-pressed="true"] {
		background: color-mix(in srgb, var(--grip) 14%, transparent);
		border-color: color-mix(in srgb, var(--grip) 60%, transparent);
		color: var(--grip);
	}
	.bar button:focus-visible {
		outline: 2px solid var(--grip);
		outline-offset: 1px;
	}
	.bar button:disabled {
		opacity: 0.4;
		cursor: default;
	}
	.bar svg {
		width: 20px;
		height: 20px;
		fill: none;
		stroke: currentColor;
		stroke-width: 1.4;
		stroke-linecap: round;
		stroke-linejoin: round;
	}
	@media (pointer: coarse) {
		.field {
			bottom: 50px;
		}
		.bar {
			height: 44px;
		}
	}
	/* A leaf is taller than wide: where height is dear, the buttons stand beside it. */
	@container (orientation: landscape) {
		.field {
			inset: 0 54px 0 0;
		}
		.bar {
			inset: 0 0 0 auto;
			flex-direction: column;
			width: 44px;
			height: auto;
		}
		.bar button {
			width: 100%;
			max-width: none;
			max-height: 56px;
		}
	}
`;
