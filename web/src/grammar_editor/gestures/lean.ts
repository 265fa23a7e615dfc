/**
 * Bending towards the circle (Petrenko 2014, section 4.3.3, figure 47). A constant of the text bends a stem to the
 * plant's right (+X) above the middle of its range, and to the left below it. From behind, the screen shows the
 * opposite.
 */
import type { Matrix4 } from "three";

/**
 * Returns the share of a bend to the plant's right that is to the right on the screen: 1 from in front, −1 from
 * behind, 0 from the side.
 * @param view the camera's `matrixWorld`
 */
export const toTheRight = ({ elements }: Matrix4): number => elements[0];

/** Converts a share of a constant's range to the circle's horizontal position, and back. */
export const acrossScreen = (share: number, right: number): number => (right < 0 ? 1 - share : share);
