//! What every boundary element owes: shape functions that are one at their node and zero at the others, that add
//! up to one, and that follow smooth fields to second order.

use approx::assert_relative_eq;
use archard::compliance::bem::element::{ELEMENTS, Element, evaluate};

/// Places all over the reference face, its corners among them.
fn places(element: &Element) -> Vec<[f64; 2]> {
    let corners = element.corners;
    let mix = |shares: [f64; 3], last: usize| {
        let parts = shares.into_iter().zip([corners[0], corners[1], corners[last]]);
        parts.fold([0.0; 2], |sum, (share, at)| [sum[0] + share * at[0], sum[1] + share * at[1]])
    };
    let shares = [[1.0, 0.0, 0.0], [0.2, 0.5, 0.3], [0.6, 0.1, 0.3], [0.1, 0.0, 0.9]];
    let last = corners.len() - 1;
    corners.iter().copied().chain(shares.map(|shares| mix(shares, last))).collect()
}

#[test]
fn shape_functions_belong_to_their_nodes_and_add_up_to_one() {
    for element in ELEMENTS {
        assert_eq!(element.nodes.len(), element.shape.len(), "{}", element.name);
        for (own, shape) in element.shape.iter().enumerate() {
            for (node, at) in element.nodes.iter().enumerate() {
                let expected = if node == own { 1.0 } else { 0.0 };
                assert_relative_eq!(evaluate(shape, *at), expected, epsilon = 1e-14);
            }
        }
        for at in places(element) {
            for functions in [element.shape, element.map] {
                let sum: f64 = functions.iter().map(|function| evaluate(function, at)).sum();
                assert_relative_eq!(sum, 1.0, epsilon = 1e-14);
            }
        }
        assert_eq!(element.continuous, element.nodes == element.corners, "{}", element.name);
    }
}

#[test]
fn corners_are_where_the_map_puts_them() {
    for element in ELEMENTS {
        for (own, corner) in element.map.iter().enumerate() {
            for (other, at) in element.corners.iter().enumerate() {
                assert_eq!(evaluate(corner, *at), if own == other { 1.0 } else { 0.0 });
            }
        }
    }
}

/// Largest error of a smooth field on an element of that size.
fn error(element: &Element, size: f64) -> f64 {
    let field = |[s, t]: [f64; 2]| (size * s).exp() * (1.0 + size * t).cos();
    let at_nodes: Vec<f64> = element.nodes.iter().map(|node| field(*node)).collect();
    let apart = |at: [f64; 2]| {
        let found: f64 = element
            .shape
            .iter()
            .zip(&at_nodes)
            .map(|(shape, value)| evaluate(shape, at) * value)
            .sum();
        (found - field(at)).abs()
    };
    places(element).into_iter().map(apart).fold(0.0, f64::max)
}

#[test]
fn fields_are_followed_to_second_order() {
    for element in ELEMENTS {
        let order = (error(element, 0.02) / error(element, 0.01)).log2();
        assert!((order - 2.0).abs() < 0.1, "{}: {order}", element.name);
    }
}
