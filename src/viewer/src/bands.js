// Bands of colour along elements: the classes of pictures (src/output/bars.cpp), and the course of a value between the
// two ends of an element. The shader (scene.js) computes the value and its class at each pixel.
import { along, f_y, force } from "./run_data.js";

/// f_y in fifths, and f_y = 1: the colours of pictures, src/output/colours.h
export const band_colours = ["#28428c", "#4688c8", "#96d4e2", "#fad650", "#ec7e2c", "#ac142c"];

// The last class is of what has reached 1, up to the tolerance of the return to the yield surface.
const from = [0.2, 0.4, 0.6, 0.8, 0.999];

/// The class of a share from 0 to 1.
export function class_of(share) {
  let k = 0;
  while (k < 5 && share >= from[k]) ++k;
  return k;
}

// Adds the square of a quantity that goes in a straight line from a to b to the course out[0] + out[1] t + out[2] t^2.
function add_square(out, a, b) {
  out[0] += a * a, out[1] += 2 * a * (b - a), out[2] += (b - a) * (b - a);
}

/// Of each, for a frame: from, the least values of classes 1 to 5; course(bar, out) puts three coefficients of a course
/// into out, and the most that it may reach. The ends' moments alone are in the data, so moments go in a straight line
/// between them. Under a spread load the moment is a parabola, which a picture shows and the player does not.
export const bands_of = {
  // f_y of eq 14: N and Mz are the same all along. The element's own f_y is the most: N is that of the end where it is
  // larger. An element without limits has its own f_y all along. Of another law: a parabola through the values at the
  // ends and in the middle.
  f_y: (frames, frame) => ({ from, course(b, out) {
    const { limits } = frames, own = f_y(frames, frame, b), values = along(frames, frame, b);
    if (values) {
      const [first, middle, last] = values;
      out[0] = first, out[1] = 4 * middle - 3 * first - last, out[2] = 2 * (first - 2 * middle + last);
      out[3] = Math.max(first, middle, last);
      return;
    }
    const part = (c, limit) => (limits[4 * b + limit] > 0 ? force(frames, frame, b, c) / limits[4 * b + limit] : 0);
    out[0] = part(0, 0) ** 2 + part(5, 3) ** 2, out[1] = out[2] = 0, out[3] = own;
    add_square(out, part(1, 1), part(2, 1));
    add_square(out, part(3, 2), part(4, 2));
    if ([0, 1, 2, 3].every((c) => !(limits[4 * b + c] > 0))) out[0] = own;
  } }),
  // The square of M / M0, which is a polynomial; so the classes begin at squares, too.
  bending: (frames, frame) => ({ from: from.map((v) => v * v), course(b, out) {
    const { limits, largest_moment } = frames;
    const part = (c, limit) => force(frames, frame, b, c) / (limits[4 * b + limit] || largest_moment || 1);
    out[0] = out[1] = out[2] = 0, out[3] = 1e30;
    add_square(out, part(1, 1), part(2, 1));
    add_square(out, part(3, 2), part(4, 2));
  } }),
};
