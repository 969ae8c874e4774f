/** Where the wheel is in the track. */
import type { Line, Outlines } from '../solver/protocol';

/** Place and attitude of the wheelset: lengths in m, the angle in rad. */
export interface Pose {
  /** To the left. */
  lateral: number;
  /** That at which the outlines are. */
  outlined: number;
  height: number;
  roll: number;
}

/** Places of the wheel in the track, in m: turned about the middle of the axle and moved. */
export function placedWheel({ wheel, radius }: Outlines, pose: Pose): Line {
  const [sin, cos] = [Math.sin(pose.roll), Math.cos(pose.roll)];
  const across = wheel.y.map((y) => y - pose.outlined);
  const up = wheel.z.map((z) => z - radius);
  const turned = (index: number, onY: number, onZ: number) =>
    onY * (across[index] ?? NaN) + onZ * (up[index] ?? NaN);
  return {
    y: across.map((_, index) => pose.lateral + turned(index, cos, -sin)),
    z: across.map((_, index) => radius + pose.height + turned(index, sin, cos)),
  };
}
