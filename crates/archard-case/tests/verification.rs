//! The program against closed forms and independent solutions.

mod common;
mod framed;
mod surfaces;

mod verification {
    mod accuracy;
    mod accuracy_of_edges;
    mod accuracy_of_laws;
    mod cattaneo_mindlin;
    mod chosen_frames;
    mod compliance;
    mod conforming;
    mod edges;
    mod elastic_bodies;
    mod fitted;
    mod flash_temperature;
    mod fretting_life;
    mod fretting_wear;
    mod friction_circumstances;
    mod friction_laws;
    mod growing_frames;
    mod hertz;
    mod laws_that_remember;
    mod layers;
    mod life;
    mod line_contact;
    mod loading_paths;
    mod meshed_contact;
    mod meshed_rolling;
    mod meshes_that_do_not_match;
    mod only_k_s;
    mod orthotropic;
    mod own_wear_law;
    mod parts_of_the_frame;

    mod periodic;
    mod pin_on_disc;
    mod punch;
    mod punch_cycles;
    mod rolling;
    mod rolling_on_triangles;
    mod rolling_order;
    mod rolling_wear;
    mod rotation;
    mod rough;
    mod running_in;
    mod similarity;
    mod slender_bodies;
    mod sneddon;
    mod spence;
    mod standards;
    mod step_by_error;
    mod stresses_of_half_spaces;
    mod stresses_of_image_fields;
    mod stresses_under_contact;
    mod superelement;
    mod swinging;
    mod t_gamma;
    mod tetrahedra;
    mod track;
    mod unequal_pairs;
    mod wear_laws;
    mod wider_frames;
    mod windows;
    mod yielding;
}
