//! What a plane frame neglects of bodies that conform, as a ball and its socket.

use crate::body::{Body, profile::circle_recess};

/// What counts against the small gap of bodies, one of them hollow, at the edge of their contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConformingEdge {
    /// The gap between the profiles without that between circles of the same curvatures, over the gap: the terms of fourth and
    /// higher order that a paraboloid lacks. Infinite where a circle ends before the contact. A share e of a gap of second order
    /// changes Hertz's largest pressure under a load by 16 e/45 at first (I. N. Sneddon, *Int. J. Eng. Sci.* 3 (1965) 47).
    pub form: f64,
    /// Slope of the surface halfway between the bodies. Pressures act along it and close gaps along it, which a plane frame does
    /// not know: both differ by parts of the order of its square.
    pub slope: f64,
}

impl ConformingEdge {
    /// Of a contact that reaches so far (m) from its middle along x and y; the larger numbers of both axes. `None` where the bodies
    /// do not conform, or have no curvatures.
    pub fn of(bodies: &[Body; 2], reach: [f64; 2]) -> Option<Self> {
        let [one, two] = bodies.each_ref().map(Body::curvatures);
        let (one, two) = (one?, two?);
        let along = |axis: usize| {
            let (curvatures, reach) = ([one[axis], two[axis]], reach[axis]);
            let conforms = curvatures[0] * curvatures[1] < 0.0 && reach > 0.0 && reach.is_finite();
            conforms.then(|| Self {
                form: form(bodies, curvatures, axis, reach),
                slope: 0.5 * (curvatures[0] - curvatures[1]).abs() * reach,
            })
        };
        let worst = |one: Self, two: Self| Self {
            form: one.form.max(two.form),
            slope: one.slope.max(two.slope),
        };
        (0..2).filter_map(along).reduce(worst)
    }
}

/// The gap off that of circles, over it, at some distance (m) along an axis.
fn form(bodies: &[Body; 2], curvatures: [f64; 2], axis: usize, reach: f64) -> f64 {
    let place = if axis == 0 { [reach, 0.0] } else { [0.0, reach] };
    let recess = bodies.each_ref().map(|body| body.profile.recess(place[0], place[1]));
    let off = |body: usize| recess[body] - circle_recess(curvatures[body].recip(), reach);
    let share = (off(0) + off(1)).abs() / recess.iter().sum::<f64>().abs();
    if share.is_nan() { f64::INFINITY } else { share }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::ConformingEdge;
    use crate::body::Body;
    use crate::body::profile::{Cylinder, Flat, Paraboloid, Profile, Sphere};

    fn of(
        one: impl Profile + 'static,
        two: impl Profile + 'static,
        reach: [f64; 2],
    ) -> Option<ConformingEdge> {
        ConformingEdge::of(&[Body::new("one", one), Body::new("two", two)], reach)
    }

    fn sphere(radius: f64) -> Sphere {
        Sphere::new(radius).unwrap()
    }

    /// The first neglected term of a circle is r^4/(8 R^3), the gap r^2/2 times the sum of the curvatures.
    #[test]
    fn a_parabola_for_a_socket_lacks_its_fourth_order() {
        let (ball, socket, reach) = (50e-3_f64, -50.01e-3_f64, 1e-3_f64);
        let hollow = of(sphere(ball), sphere(socket), [reach; 2]).unwrap();
        assert!(hollow.form < 1e-9, "{hollow:?}");
        assert_relative_eq!(hollow.slope, 0.5 * reach * (1.0 / ball - 1.0 / socket));
        let found = of(sphere(ball), Paraboloid::new([socket; 2]).unwrap(), [reach; 2]).unwrap();
        let fourth = reach.powi(4) / 8.0 / socket.abs().powi(3);
        let gap = 0.5 * reach.powi(2) * (1.0 / ball + 1.0 / socket);
        let expected = fourth / (gap + reach.powi(4) / 8.0 / ball.powi(3));
        assert_relative_eq!(found.form, expected, max_relative = 1e-3);
    }

    #[test]
    fn bodies_that_do_not_conform_have_no_such_numbers() {
        assert_eq!(of(sphere(5e-3), Flat, [1e-3; 2]), None);
        assert_eq!(of(sphere(5e-3), Cylinder::along_y(-6e-3).unwrap(), [0.0, 1e-3]), None);
        let short = of(sphere(5e-3), Paraboloid::new([-6e-3; 2]).unwrap(), [7e-3; 2]);
        assert_eq!(short.unwrap().form, f64::INFINITY);
    }
}
