//! The image fields of two bodies on rectangles of their faces, found once each.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use faer::Mat;

use crate::body::mesh::{Mesh, Volume};
use crate::body::{Body, Elasticity, Finite, Material};
use crate::compliance::bem::contact::{ContactError, supported};
use crate::compliance::bem::image::{
    ImageBody, MISSED, MOST_DEGREES, NoImage, Polynomials, degree, degree_inside, holds,
};
use crate::compliance::bem::{Conditions, Surface};
use crate::compliance::fem::{ImageField, Solid};
use crate::compliance::image::ends::Inside;
use crate::frame::Rectangle;

/// How much larger rectangles become: as frames do that grow at each side by an eighth. A choice of cost.
const STEP: f64 = 1.25;

/// The image fields of both bodies.
#[derive(Debug, Clone)]
pub(super) struct Fields {
    pub polynomials: Arc<Polynomials>,
    /// (m/N) between polynomials on the axes of the frame: row and column d m + i.
    pub compliance: Arc<Mat<f64>>,
    /// What half the elements of the bodies changed in it (m/N).
    pub change: Arc<Mat<f64>>,
    /// What the last degree of the polynomials adds to it (m/N).
    pub last: Arc<Mat<f64>>,
    /// What it is more where each body is moved to, at the ends of its ways, than in the middle (m/N).
    pub moved: Vec<Vec<Arc<Mat<f64>>>>,
}

/// Bodies with image fields.
#[derive(Debug)]
pub(super) struct Known {
    bodies: Vec<One>,
    /// What the frame covered at first.
    first: Rectangle,
    /// How often that was enlarged, and the fields there.
    found: Mutex<Vec<(u32, Fields)>>,
}

/// A body and what finds its field.
#[derive(Debug)]
pub(super) struct One {
    which: usize,
    pub finite: Finite,
    engine: Engine,
    material: Material,
    /// By how much it is moved under the contact (m).
    offsets: Rectangle,
}

/// What finds the field of a body.
#[derive(Debug)]
enum Engine {
    /// Boundary elements on its surface: the mesh of elements half as long.
    Surface(Mesh),
    /// Finite elements inside it, which are factorised once.
    Volume(Arc<Volume>, Box<OnceLock<Solid>>),
}

impl Known {
    /// The bodies that have them, moved under the contact by offsets (m), on a rectangle.
    pub fn new(bodies: [&Body; 2], offsets: [Rectangle; 2], first: Rectangle) -> Self {
        let of = |(which, body): (usize, &Body)| {
            let finite = body.finite.clone()?;
            let material = body.material?;
            let imaged = finite.elasticity == Elasticity::Image;
            let engine = match &finite.meshed.volume {
                Some(volume) => Engine::Volume(Arc::clone(volume), Box::default()),
                None => Engine::Surface(finite.meshed.mesh.divided()),
            };
            let offsets = offsets[which];
            imaged.then_some(One { which, finite, engine, material, offsets })
        };
        let bodies = bodies.into_iter().enumerate().filter_map(of).collect();
        Self { bodies, first, found: Mutex::new(vec![]) }
    }

    /// The fields on the first rectangle, or on that one enlarged about its middle until it covers another, as far as the faces reach.
    /// They follow from the rectangle alone, whatever was asked for before.
    ///
    /// # Errors
    /// If a body's face ends before, a body is not held, or its equations have no solution.
    pub fn over(&self, rectangle: Rectangle) -> Result<Fields, ContactError> {
        self.bodies.iter().try_for_each(|one| one.holds(&rectangle))?;
        let steps = (0..).find(|times| covers(self.enlarged(*times), rectangle)).unwrap_or(0);
        let found = || self.found.lock().unwrap_or_else(PoisonError::into_inner);
        let known = found().iter().find(|(times, _)| *times == steps).cloned();
        if let Some((_, fields)) = known {
            return Ok(fields);
        }
        // Nobody waits meanwhile: threads that wait for others may come here.
        let fields = self.fields(self.within_the_faces(steps))?;
        found().push((steps, fields.clone()));
        Ok(fields)
    }

    /// One of the bodies, by its index; `None` where it has no image field.
    pub fn of_body(self, which: usize) -> Option<One> {
        self.bodies.into_iter().find(|one| one.which == which)
    }

    /// Whether bodies are held and their faces hold the first rectangle wherever they are moved.
    pub fn meets(&self) -> Result<(), ContactError> {
        for one in &self.bodies {
            let Finite { meshed, interpolation, mirrored, .. } = &one.finite;
            let surface = Surface::new(&meshed.mesh, *interpolation, *mirrored);
            Conditions::new(&surface, |node| supported(&one.finite, node), &[])
                .map_err(|cause| ContactError::Undetermined { body: one.which, cause })?;
            one.holds(&self.first)?;
        }
        Ok(())
    }

    fn enlarged(&self, times: u32) -> Rectangle {
        let size = self.first.size.map(|size| size * STEP.powi(times as i32));
        Rectangle { size, ..self.first }
    }

    /// The first rectangle, enlarged so often, as far as the faces reach along each axis.
    fn within_the_faces(&self, times: u32) -> Rectangle {
        let (first, all) = (self.first, self.enlarged(times));
        let mut rectangle = all;
        for axis in 0..2 {
            let mut low = first.corner()[axis].min(all.corner()[axis]);
            let mut high = low + all.size[axis];
            for one in &self.bodies {
                let [least, most] = one.reach(axis);
                (low, high) = (low.max(least), high.min(most));
            }
            rectangle.centre[axis] = 0.5 * (low + high);
            rectangle.size[axis] = high - low;
        }
        rectangle
    }

    fn fields(&self, rectangle: Rectangle) -> Result<Fields, ContactError> {
        let degree = self.bodies.iter().map(|one| one.degree(&rectangle)).max().unwrap_or(0);
        let polynomials = Polynomials::new(rectangle, degree);
        let size = 3 * polynomials.degrees().len();
        let (mut sum, mut change) = (Mat::zeros(size, size), Mat::<f64>::zeros(size, size));
        let mut moved = vec![];
        for one in &self.bodies {
            let found = one.found(&polynomials)?;
            let middle = match one.engine {
                Engine::Surface(_) => &found.compliance - &found.change,
                Engine::Volume(..) => found.compliance.clone(),
            };
            let there =
                |end| Ok(Arc::new(one.as_coarse(&Polynomials::new(end, degree))? - &middle));
            moved.push(one.ends(&rectangle).map(there).collect::<Result<_, ContactError>>()?);
            change += found.change;
            sum += found.compliance;
        }
        let degrees = polynomials.degrees();
        let is_last = |place: usize| degrees[place % degrees.len()].iter().sum::<usize>() == degree;
        let last = Mat::from_fn(size, size, |row, column| {
            if is_last(row) || is_last(column) { sum[(row, column)] } else { 0.0 }
        });
        let [compliance, change, last] = [sum, change, last].map(Arc::new);
        Ok(Fields { polynomials: Arc::new(polynomials), compliance, change, last, moved })
    }
}

impl One {
    /// K on the axes of the frame, and what half the elements or cubic functions change in it.
    fn found(&self, polynomials: &Polynomials) -> Result<ImageField, ContactError> {
        let ImageField { compliance, change } = match &self.engine {
            Engine::Surface(fine) => {
                let compliance = self.by_surface(fine, polynomials)?;
                let change =
                    &compliance - self.by_surface(&self.finite.meshed.mesh, polynomials)?;
                ImageField { compliance, change }
            }
            Engine::Volume(volume, solid) => self.solid(volume, solid)?.image(polynomials),
        };
        Ok(ImageField {
            compliance: self.on_the_frame(compliance),
            change: self.on_the_frame(change),
        })
    }

    /// K on the axes of the frame, of elements that are not halved.
    fn as_coarse(&self, polynomials: &Polynomials) -> Result<Mat<f64>, ContactError> {
        Ok(self.on_the_frame(match &self.engine {
            Engine::Surface(_) => self.by_surface(&self.finite.meshed.mesh, polynomials)?,
            Engine::Volume(volume, solid) => self.solid(volume, solid)?.compliance(polynomials),
        }))
    }

    /// The field inside under loads (N) of polynomials; of elements on its surface that are halved or not.
    pub fn inside(
        &self,
        polynomials: &Polynomials,
        loads: &[f64],
        halved: bool,
    ) -> Result<Inside, ContactError> {
        match &self.engine {
            Engine::Surface(fine) => {
                let mesh = if halved { fine } else { &self.finite.meshed.mesh };
                let found = self.imaged(mesh).inside(polynomials, loads);
                found.map(Box::new).map(Inside::Surface).map_err(|cause| self.failed(cause))
            }
            Engine::Volume(volume, solid) => {
                Ok(Inside::Volume(self.solid(volume, solid)?.inside(polynomials, loads)))
            }
        }
    }

    fn by_surface(&self, mesh: &Mesh, polynomials: &Polynomials) -> Result<Mat<f64>, ContactError> {
        self.imaged(mesh).compliance(polynomials).map_err(|cause| self.failed(cause))
    }

    fn imaged<'a>(&'a self, mesh: &'a Mesh) -> ImageBody<'a> {
        ImageBody { finite: &self.finite, mesh, material: &self.material }
    }

    fn failed(&self, cause: NoImage) -> ContactError {
        match cause {
            NoImage::Undetermined(cause) => ContactError::Undetermined { body: self.which, cause },
            NoImage::Unsolved(cause) => ContactError::Singular { body: self.which, cause },
        }
    }

    fn solid<'a>(
        &self,
        volume: &Arc<Volume>,
        known: &'a OnceLock<Solid>,
    ) -> Result<&'a Solid, ContactError> {
        if let Some(solid) = known.get() {
            return Ok(solid);
        }
        // Nobody waits meanwhile: threads that wait for others may come here.
        let solid = Solid::new(&self.finite, volume, &self.material);
        let solid = solid.map_err(|cause| ContactError::Singular { body: self.which, cause })?;
        Ok(known.get_or_init(|| solid))
    }

    /// The same on the axes of the frame. Body 2 is turned over, x and y as they are: what is normal changes its sign.
    fn on_the_frame(&self, own: Mat<f64>) -> Mat<f64> {
        let count = own.nrows() / 3;
        let over = |place: usize| self.which == 1 && place / count == 2;
        Mat::from_fn(own.nrows(), own.ncols(), |row, column| {
            if over(row) == over(column) { own[(row, column)] } else { -own[(row, column)] }
        })
    }

    /// The degree of polynomials by which loads on a rectangle are known anywhere in the body.
    pub fn degree_inside(&self, rectangle: &Rectangle) -> usize {
        let Finite { meshed, mirrored, .. } = &self.finite;
        degree_inside(&meshed.mesh, *mirrored, rectangle, MISSED).unwrap_or(MOST_DEGREES)
    }

    fn degree(&self, rectangle: &Rectangle) -> usize {
        let Self { finite, .. } = self;
        degree(&finite.meshed.mesh, finite.mirrored, rectangle, MISSED).unwrap_or(MOST_DEGREES)
    }

    /// Whether its face holds a rectangle wherever it is moved.
    fn holds(&self, rectangle: &Rectangle) -> Result<(), ContactError> {
        let Finite { meshed, mirrored, .. } = &self.finite;
        let held = |rectangle: &Rectangle| holds(&meshed.mesh, *mirrored, rectangle);
        match held(rectangle) {
            false => Err(ContactError::BesideTheFace),
            _ if self.ends(rectangle).all(|end| held(&end)) => Ok(()),
            _ => Err(ContactError::LeavesTheFace { body: self.which }),
        }
    }

    /// Where a rectangle of the frame lies on the body at the ends of its ways, as far as it is moved.
    pub fn ends(&self, rectangle: &Rectangle) -> impl Iterator<Item = Rectangle> + use<> {
        let rectangle = *rectangle;
        let offsets = self.offsets.corners();
        let differs = move |end: &usize| {
            offsets[*end] != [0.0; 2] && !offsets[..*end].contains(&offsets[*end])
        };
        (0..offsets.len()).filter(differs).map(move |end| {
            let centre = [0, 1].map(|axis| rectangle.centre[axis] - offsets[end][axis]);
            Rectangle { centre, ..rectangle }
        })
    }

    /// From where to where the body reaches along an axis (m).
    fn reach(&self, axis: usize) -> [f64; 2] {
        let mesh = &self.finite.meshed.mesh;
        let [low, high] = mesh.bounds(0..mesh.faces.len()).map(|corner| corner[axis]);
        if self.finite.mirrored[axis] { [-high, high] } else { [low, high] }
    }
}

/// Whether a rectangle covers another, but for rounding.
fn covers(one: Rectangle, other: Rectangle) -> bool {
    (0..2).all(|axis| {
        let beside = (one.centre[axis] - other.centre[axis]).abs();
        2.0 * beside + other.size[axis] <= one.size[axis] * (1.0 + crate::numerics::SAME)
    })
}
