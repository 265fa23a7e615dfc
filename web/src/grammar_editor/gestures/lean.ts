/**
 * Bending towards the circle (Petrenko 2014, section 4.3.3, figure 47). A text's constant bends a stem to the right of a plant that is seen
 * from in front (+X), and to the left where it is below the middle of its range. On the screen that is the other way round from behind.
 */
import type { Matrix4 } from "three";

/**
 * How much of a bend to the plant's right is to the right on the screen: 1 from in front, −1 from behind, 0 from the side.
 * @param view the camera's `matrixWorld`
 */
export const toTheRight = ({ elements }: Matrix4): number => elements[0];

/** Where a share of a constant's way has the circle across the screen; the same turns the circle's place into the share. */
export const acrossScreen = (share: number, right: number): number => (right < 0 ? 1 - share : share);
