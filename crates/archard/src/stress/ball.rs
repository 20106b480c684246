//! The smallest ball around points.
//!
//! E. Welzl (*Lecture Notes in Computer Science* 555 (1991) 359): a point outside of the ball around those before it lies on the
//! surface of the ball around them all.

/// How far outside a point may lie, relative to the radius: above the rounding of the few equations a ball follows from, below any
/// stress's own error.
const NEAR: f64 = 1e-12;

/// A ball, by its centre and radius.
type Ball<const N: usize> = ([f64; N], f64);

/// Centre and radius of the smallest ball around points; a radius of zero without any.
pub fn smallest_ball<const N: usize>(points: &[[f64; N]]) -> Ball<N> {
    around(&mut points.to_vec(), &mut vec![])
}

/// The ball around points with some more on its surface. Points that make it grow come first the next time.
fn around<const N: usize>(points: &mut [[f64; N]], surface: &mut Vec<[f64; N]>) -> Ball<N> {
    let mut ball = through(surface).unwrap_or(([0.0; N], 0.0));
    if surface.len() > N {
        return ball;
    }
    for index in 0..points.len() {
        let point = points[index];
        let outside = surface.is_empty() && index == 0
            || apart(&point, &ball.0) > ball.1 * (1.0 + NEAR) + f64::MIN_POSITIVE;
        if !outside {
            continue;
        }
        surface.push(point);
        // A point that is no corner of its own changes nothing.
        if through(surface).is_some() {
            ball = around(&mut points[..index], surface);
            points[..=index].rotate_right(1);
        }
        surface.pop();
    }
    ball
}

/// The smallest ball with all of these points on its surface; `None` without any, and where one of them depends on the others.
fn through<const N: usize>(surface: &[[f64; N]]) -> Option<Ball<N>> {
    let (first, others) = surface.split_first()?;
    let count = others.len();
    let from: Vec<[f64; N]> =
        others.iter().map(|own| std::array::from_fn(|i| own[i] - first[i])).collect();
    let dot = |a: &[f64; N], b: &[f64; N]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // 2 G s = diag G for the shares s of the centre, by elimination: G is positive definite.
    let mut rows: Vec<Vec<f64>> = (0..count)
        .map(|i| {
            let own = (0..count).map(|j| 2.0 * dot(&from[i], &from[j]));
            own.chain([dot(&from[i], &from[i])]).collect()
        })
        .collect();
    for pivot in 0..count {
        let scale = 2.0 * rows[pivot][count].max(dot(&from[pivot], &from[pivot]));
        if rows[pivot][pivot] <= NEAR * NEAR * scale {
            return None;
        }
        let (above, below) = rows.split_at_mut(pivot + 1);
        for row in below {
            let factor = row[pivot] / above[pivot][pivot];
            row.iter_mut().zip(&above[pivot]).for_each(|(own, other)| *own -= factor * other);
        }
    }
    let mut shares = vec![0.0; count];
    for row in (0..count).rev() {
        let known: f64 = (row + 1..count).map(|other| rows[row][other] * shares[other]).sum();
        shares[row] = (rows[row][count] - known) / rows[row][row];
    }
    let centre: [f64; N] = std::array::from_fn(|i| {
        first[i] + from.iter().zip(&shares).map(|(own, share)| share * own[i]).sum::<f64>()
    });
    Some((centre, apart(first, &centre)))
}

fn apart<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}
