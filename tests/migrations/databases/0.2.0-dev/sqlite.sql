BEGIN TRANSACTION;
CREATE TABLE alembic_version (
	version_num VARCHAR(32) NOT NULL, 
	CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num)
);
INSERT INTO "alembic_version" VALUES('0007');
CREATE TABLE api_key (
	id INTEGER NOT NULL, 
	name VARCHAR NOT NULL, 
	scope VARCHAR(16) NOT NULL, 
	hash VARCHAR(64) NOT NULL, 
	max_queued_cases INTEGER, 
	cpu_s_per_day DOUBLE, 
	created_at DOUBLE NOT NULL, 
	revoked_at DOUBLE, 
	last_used_at DOUBLE, 
	CONSTRAINT pk_api_key PRIMARY KEY (id), 
	CONSTRAINT uq_api_key_name UNIQUE (name)
);
INSERT INTO "api_key" VALUES(1,'anna','write','0fabfc0e00659cc613905286ee3c36ab3eade283cbbee2daee46a3cc9c1a1d65',NULL,NULL,1795341458.866,NULL,NULL);
CREATE TABLE "case" (
	id INTEGER NOT NULL, 
	digest VARCHAR(64) NOT NULL, 
	solver_version VARCHAR NOT NULL, 
	operator_key VARCHAR(64) NOT NULL, 
	inputs JSON NOT NULL, 
	speed_kmh DOUBLE NOT NULL, 
	slab VARCHAR NOT NULL, 
	irregularity VARCHAR NOT NULL, 
	spectrum VARCHAR, 
	percentile DOUBLE, 
	wavelength_min_m DOUBLE, 
	wavelength_max_m DOUBLE, 
	seed INTEGER, 
	realisation INTEGER, 
	wavelength_m DOUBLE, 
	amplitude_mm DOUBLE, 
	state VARCHAR(16) NOT NULL, 
	priority INTEGER NOT NULL, 
	attempt INTEGER NOT NULL, 
	lease_token VARCHAR(32), 
	lease_expires DOUBLE, 
	heartbeat_at DOUBLE, 
	worker VARCHAR, 
	progress DOUBLE NOT NULL, 
	error JSON, 
	cpu_s DOUBLE, 
	created_at DOUBLE NOT NULL, 
	started_at DOUBLE, 
	finished_at DOUBLE, processing JSON, turn INTEGER DEFAULT '0' NOT NULL, work DOUBLE, charged_to INTEGER, 
	CONSTRAINT pk_case PRIMARY KEY (id), 
	CONSTRAINT ck_case_state CHECK (state IN ('queued', 'running', 'succeeded', 'failed', 'cancelled')), 
	CONSTRAINT uq_case_digest_solver_version UNIQUE (digest, solver_version)
);
INSERT INTO "case" VALUES(1,'3d97b198e43bb981a1f36aa43f76c6070bfee4954903a41a81408e2aa6a78e72','3','d3461839b0349939ceb9d50ba75bfb95fd8723a21ec11e200b8c624f852b4e11','{"speed": 83.33333333333333, "slab": "continuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 50000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}',300.0,'continuous','harmonic',NULL,NULL,NULL,NULL,NULL,NULL,1.0,0.3,'succeeded',0,1,NULL,NULL,1795341453.067,'host:26960',1.0,NULL,4.39421543999998220897e-01,1795341361.854,1795341453.067,1795341453.534,'{"sampling_step_s": 0.0001, "samples": 2000, "window_s": 0.2, "settle_s": 0.3, "ease_in_s": 0.2, "filters": {"wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": 20.0, "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.05}, "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": [0.4, 10.0], "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.19990000000000002}}, "quantile": 0.9985, "sperling_index": {"window_s": 0.2, "windows": 1, "band_hz": [0.5, 80.0]}, "contact_lost_at_or_below_n": 0.0, "conventions": {"direction": "displacements and accelerations are positive downwards", "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that moves with it", "wheel_rail_force": "of one wheel; compression is positive", "slab_moment": "of half the slab; positive where the underside is stretched", "pad_force": "of one pad, the largest of all pads under the train; compression is positive", "roadbed_pressure": "of half the base per length of track, N/m; compression is positive"}}',0,16560000.0,NULL);
INSERT INTO "case" VALUES(2,'a70bd0855c2e1144d06783926e33eab0e3d31ea8e4b2d741569e56f050dea0ce','3','929dfa39852d5f6aaa343b3703d8d7b46b4afc39b38315eb1fd72ad06028f6a0','{"speed": 83.33333333333333, "slab": "discontinuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 50000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}',300.0,'discontinuous','harmonic',NULL,NULL,NULL,NULL,NULL,NULL,1.0,0.3,'succeeded',0,1,NULL,NULL,1795341454.248,'host:26960',1.0,NULL,1.09905142799999566705e+00,1795341361.854,1795341453.555,1795341454.667,'{"sampling_step_s": 0.0001, "samples": 2000, "window_s": 0.2, "settle_s": 0.3, "ease_in_s": 0.2, "filters": {"wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": 20.0, "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.05}, "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": [0.4, 10.0], "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.19990000000000002}}, "quantile": 0.9985, "sperling_index": {"window_s": 0.2, "windows": 1, "band_hz": [0.5, 80.0]}, "contact_lost_at_or_below_n": 0.0, "conventions": {"direction": "displacements and accelerations are positive downwards", "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that moves with it", "wheel_rail_force": "of one wheel; compression is positive", "slab_moment": "of half the slab; positive where the underside is stretched", "pad_force": "of one pad, the largest of all pads under the train; compression is positive", "roadbed_pressure": "of half the base per length of track, N/m; compression is positive"}}',1,16560000.0,NULL);
INSERT INTO "case" VALUES(3,'afff6f7819ded79cd33ca12e051208c5d1279656ee963780a87553aaa05fcf9c','3','b305072880b3d13a013ac469bc43a37099d217fb92ba67616a02cb34d8b13063','{"speed": 69.44444444444444, "slab": "continuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 60000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "spectrum", "wavelength_min": 2.0, "wavelength_max": 30.0, "spectrum": "tb3352-ballastless", "percentile": 25.0, "seed": 7, "realisation": 0}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}',250.0,'continuous','spectrum','tb3352-ballastless',25.0,2.0,30.0,7,0,NULL,NULL,'succeeded',0,1,NULL,NULL,1795341454.743,'host:26960',1.0,NULL,5.22493112999995901191e-01,1795341454.717,1795341454.743,1795341455.29,'{"sampling_step_s": 9.95744680851064e-05, "samples": 2009, "window_s": 0.20004510638297873, "settle_s": 0.3, "ease_in_s": 0.2, "filters": {"wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": 20.0, "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.04998638297872341}, "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": [0.4, 10.0], "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.19994553191489364}}, "quantile": 0.9985, "sperling_index": {"window_s": 0.20004510638297873, "windows": 1, "band_hz": [0.5, 80.0]}, "contact_lost_at_or_below_n": 0.0, "conventions": {"direction": "displacements and accelerations are positive downwards", "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that moves with it", "wheel_rail_force": "of one wheel; compression is positive", "slab_moment": "of half the slab; positive where the underside is stretched", "pad_force": "of one pad, the largest of all pads under the train; compression is positive", "roadbed_pressure": "of half the base per length of track, N/m; compression is positive"}}',2,1.66307692307692281908e+07,NULL);
INSERT INTO "case" VALUES(4,'94ce1e2b09deba1d94d6c029d116d6608377d5376009eccde29c7420a8d15c85','3','b305072880b3d13a013ac469bc43a37099d217fb92ba67616a02cb34d8b13063','{"speed": 69.44444444444444, "slab": "continuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 60000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "measured", "wavelength_min": 0.5, "wavelength_max": 24.75, "profile": "93c53feed5baaec449def0eec1a82e3241a9b1cee8d1e03b8b7eec55edb4a91e"}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}',250.0,'continuous','measured',NULL,NULL,0.5,24.75,NULL,NULL,NULL,NULL,'succeeded',0,1,NULL,NULL,1795341455.488,'host:26960',1.0,NULL,4.27038276999994081961e-01,1795341455.441,1795341455.488,1795341455.94,'{"sampling_step_s": 9.95744680851064e-05, "samples": 2009, "window_s": 0.20004510638297873, "settle_s": 0.3, "ease_in_s": 0.2, "filters": {"wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": 20.0, "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.04998638297872341}, "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": [0.4, 10.0], "kind": "Butterworth", "order_of_one_pass_per_edge": 4, "passes": "forwards and backwards, zero phase", "edges": "mirrored", "mirrored_s": 0.19994553191489364}}, "quantile": 0.9985, "sperling_index": {"window_s": 0.20004510638297873, "windows": 1, "band_hz": [0.5, 80.0]}, "contact_lost_at_or_below_n": 0.0, "conventions": {"direction": "displacements and accelerations are positive downwards", "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that moves with it", "wheel_rail_force": "of one wheel; compression is positive", "slab_moment": "of half the slab; positive where the underside is stretched", "pad_force": "of one pad, the largest of all pads under the train; compression is positive", "roadbed_pressure": "of half the base per length of track, N/m; compression is positive"}}',3,1.66307692307692281908e+07,NULL);
INSERT INTO "case" VALUES(5,'1b89d0e3a99e55271ac21a6824c6feedd2309d4f04181c1573c0f71d7c3e061f','3','bdc32dade9311c56698e03ba47da24c62dacd165ebe46b4a547d2f69b58f1a7f','{"speed": 55.55555555555556, "slab": "continuous", "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 60000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0, "joint_blending": 2.0}, "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}}',200.0,'continuous','harmonic',NULL,NULL,NULL,NULL,NULL,NULL,1.0,0.3,'queued',0,0,NULL,NULL,NULL,NULL,0.0,NULL,NULL,1795341473.493,NULL,NULL,NULL,4,16560000.0,NULL);
CREATE TABLE event (
	id INTEGER NOT NULL, 
	study_id VARCHAR(32) NOT NULL, 
	kind VARCHAR(16) NOT NULL, 
	payload JSON NOT NULL, 
	created_at DOUBLE NOT NULL, 
	CONSTRAINT pk_event PRIMARY KEY (id), 
	CONSTRAINT fk_event_study_id_study FOREIGN KEY(study_id) REFERENCES study (id) ON DELETE CASCADE
);
INSERT INTO "event" VALUES(1,'c80f9d894bc54ec981c99e1f2b70540a','state','{"state": "queued"}',1795341361.86);
INSERT INTO "event" VALUES(2,'c80f9d894bc54ec981c99e1f2b70540a','state','{"state": "running"}',1795341453.073);
INSERT INTO "event" VALUES(3,'c80f9d894bc54ec981c99e1f2b70540a','case','{"case_id": 1, "state": "succeeded"}',1795341453.546);
INSERT INTO "event" VALUES(4,'c80f9d894bc54ec981c99e1f2b70540a','case','{"case_id": 2, "state": "succeeded"}',1795341454.675);
INSERT INTO "event" VALUES(5,'c80f9d894bc54ec981c99e1f2b70540a','state','{"state": "succeeded"}',1795341454.693);
INSERT INTO "event" VALUES(6,'c80f9d894bc54ec981c99e1f2b70540a','done','{"state": "succeeded"}',1795341454.693);
INSERT INTO "event" VALUES(7,'08342e0a94b44a5f8534174c2a897c43','state','{"state": "queued"}',1795341454.72);
INSERT INTO "event" VALUES(8,'08342e0a94b44a5f8534174c2a897c43','state','{"state": "running"}',1795341454.746);
INSERT INTO "event" VALUES(9,'08342e0a94b44a5f8534174c2a897c43','case','{"case_id": 3, "state": "succeeded"}',1795341455.297);
INSERT INTO "event" VALUES(10,'08342e0a94b44a5f8534174c2a897c43','state','{"state": "succeeded"}',1795341455.304);
INSERT INTO "event" VALUES(11,'08342e0a94b44a5f8534174c2a897c43','done','{"state": "succeeded"}',1795341455.305);
INSERT INTO "event" VALUES(12,'96013dd5634143eab8ffd06dc38166b8','state','{"state": "queued"}',1795341455.444);
INSERT INTO "event" VALUES(13,'96013dd5634143eab8ffd06dc38166b8','state','{"state": "running"}',1795341455.491);
INSERT INTO "event" VALUES(14,'96013dd5634143eab8ffd06dc38166b8','case','{"case_id": 4, "state": "succeeded"}',1795341455.947);
INSERT INTO "event" VALUES(15,'96013dd5634143eab8ffd06dc38166b8','state','{"state": "succeeded"}',1795341455.952);
INSERT INTO "event" VALUES(16,'96013dd5634143eab8ffd06dc38166b8','done','{"state": "succeeded"}',1795341455.953);
INSERT INTO "event" VALUES(17,'5d1e64668089479ebc1cf6c1a6249c0f','state','{"state": "queued"}',1795341473.5);
CREATE TABLE history (
	case_id INTEGER NOT NULL, 
	"key" VARCHAR NOT NULL, 
	digest VARCHAR(64) NOT NULL, 
	size_bytes INTEGER NOT NULL, 
	CONSTRAINT pk_history PRIMARY KEY (case_id), 
	CONSTRAINT fk_history_case_id_case FOREIGN KEY(case_id) REFERENCES "case" (id) ON DELETE CASCADE
);
INSERT INTO "history" VALUES(1,'3d97b198e43bb981a1f36aa43f76c6070bfee4954903a41a81408e2aa6a78e72/1-fd78ddd4a31f43598e46a3dbc304d6bf.npz','45f291ea22ea617f1461df007d40f9752db923824d63ee36eb27829bd982fd5f',172284);
INSERT INTO "history" VALUES(2,'a70bd0855c2e1144d06783926e33eab0e3d31ea8e4b2d741569e56f050dea0ce/1-6b14c34e027b4e389bcb68ae23bc5e0b.npz','b5c7131e86e0ed4b0f31f479a93f5aee87a5402e5500a2992bbe8318e8871d2f',202794);
CREATE TABLE idempotency_key (
	"key" VARCHAR(255) NOT NULL, 
	request_digest VARCHAR(64) NOT NULL, 
	response JSON NOT NULL, 
	created_at DOUBLE NOT NULL, 
	CONSTRAINT pk_idempotency_key PRIMARY KEY ("key")
);
CREATE TABLE "peak" (
	id INTEGER NOT NULL, 
	case_id INTEGER NOT NULL, 
	quantity VARCHAR NOT NULL, 
	position VARCHAR NOT NULL, 
	unit VARCHAR NOT NULL, 
	peak DOUBLE NOT NULL, 
	maximum DOUBLE NOT NULL, 
	minimum DOUBLE NOT NULL, 
	mean DOUBLE NOT NULL, 
	std DOUBLE NOT NULL, 
	rms DOUBLE NOT NULL, 
	time_s DOUBLE NOT NULL, 
	track_position_m DOUBLE NOT NULL, 
	speed_kmh DOUBLE NOT NULL, 
	percentile DOUBLE, 
	CONSTRAINT pk_peak PRIMARY KEY (id), 
	CONSTRAINT uq_peak_case_id_quantity_position UNIQUE (case_id, quantity, position), 
	CONSTRAINT fk_peak_case_id_case FOREIGN KEY(case_id) REFERENCES "case" (id) ON DELETE CASCADE
);
INSERT INTO "peak" VALUES(1,1,'wheel_rail_force','wheelset_1','N',1.11479416516875513485e+05,1.11479416516875513485e+05,2.65322054245639155859e+04,6.84965229925658204571e+04,2.97064475913527494422e+04,7.46608779118547827248e+04,1.27600000000000018962e-01,3.563333333333333286e+01,300.0,NULL);
INSERT INTO "peak" VALUES(2,1,'wheel_rail_force','wheelset_2','N',1.09950240111038685425e+05,1.09950240111038685425e+05,2.81670524807526126091e+04,6.88414945748228201396e+04,2.86078948002407814771e+04,7.45490645159079285807e+04,2.55000000000000018318e-02,27.125,300.0,NULL);
INSERT INTO "peak" VALUES(3,1,'wheel_rail_force','wheelset_3','N',1.03982314636118913764e+05,1.03982314636118913764e+05,3.39635295495327663964e+04,6.83519983540878311046e+04,2.43512561174263355494e+04,7.25601774632181914037e+04,0.1799,3.99916666666666671403e+01,300.0,NULL);
INSERT INTO "peak" VALUES(4,1,'wheel_rail_force','wheelset_4','N',1.01782027799106435854e+05,1.01782027799106435854e+05,3.61658433053083354022e+04,6.89374691942235222081e+04,2.28393925604195537743e+04,7.26223967618355673026e+04,0.078,31.5,300.0,NULL);
INSERT INTO "peak" VALUES(5,1,'rail_displacement','wheelset_1','m',1.3610145615438312e-03,1.3610145615438312e-03,6.16509513288553481769e-04,9.83267591168442882734e-04,2.61853444685405619719e-04,1.01753741077947835666e-03,0.0806,3.17166666666666650096e+01,300.0,NULL);
INSERT INTO "peak" VALUES(6,1,'rail_acceleration','wheelset_1','m/s^2',1.31856481513149532242e+02,9.85371777789412703861e+01,-1.31856481513149532242e+02,-1.27592921611810119488e+01,7.93296661198504438061e+01,8.03492094742774867234e+01,0.1285,3.57083333333333357022e+01,300.0,NULL);
INSERT INTO "peak" VALUES(7,1,'rail_acceleration_moving_frame','wheelset_1','m/s^2',1.03798877570550047262e+02,1.01492282652764373549e+02,-1.03798877570550047262e+02,1.21543437421952948973e+00,71.8424441008485,7.18527247576706287182e+01,0.1285,3.57083333333333357022e+01,300.0,NULL);
INSERT INTO "peak" VALUES(8,1,'slab_displacement','wheelset_1','m',4.84418911875314159038e-04,4.84418911875314159038e-04,3.9184550346882689089e-04,4.38286450247039654961e-04,3.21236486093167588132e-05,4.39462104475602758236e-04,0.132,36.0,300.0,NULL);
INSERT INTO "peak" VALUES(9,1,'slab_acceleration','wheelset_1','m/s^2',1.39592751918069417631e+01,1.24067006288253338657e+01,-1.39592751918069417631e+01,-0.691644231153423,9.06785548076265257577e+00,9.09419456370299350567e+00,4.81000000000000038635e-02,2.90083333333333328587e+01,300.0,NULL);
INSERT INTO "peak" VALUES(10,1,'base_displacement','wheelset_1','m',4.6416256517194207521e-04,4.6416256517194207521e-04,3.4107655187219637757e-04,4.0224952547557172363e-04,4.3262579593681852819e-05,4.04569316110876483778e-04,0.1086,34.05,300.0,NULL);
INSERT INTO "peak" VALUES(11,1,'base_acceleration','wheelset_1','m/s^2',1.81769735950022202075e+01,1.77223601520691111943e+01,-1.81769735950022202075e+01,-4.62169084533091689692e-01,1.25414649072161488163e+01,1.25499777801250420592e+01,0.1447,3.70583333333333371224e+01,300.0,NULL);
INSERT INTO "peak" VALUES(12,1,'slab_moment','wheelset_1','N m',7.08789023651203478962e+03,7.08789023651203478962e+03,1.32407042764702055138e+03,3.75027748761608836509e+03,1.45729037096164438483e+03,4023.465727382,0.129,35.75,300.0,NULL);
INSERT INTO "peak" VALUES(13,1,'roadbed_pressure','wheelset_1','N/m',2.9737030411307565374e+04,2.9737030411307565374e+04,2.01587052125823502132e+04,2.48696999329463869807e+04,3353.58558460171,2.50947905157234163204e+04,1.07400000000000009348e-01,33.95,300.0,NULL);
INSERT INTO "peak" VALUES(14,1,'pad_force','pads','N',4.93156742578606936168e+04,4.93156742578606936168e+04,3.14302714395602743021e+04,41802.3067239934,4010.86768622959,4.1994284218727487316e+04,0.1516,3.76333333333333328605e+01,300.0,NULL);
INSERT INTO "peak" VALUES(15,1,'pad_uplift','pads','N',2.6422582740972156898e+03,2.6422582740972156898e+03,1.14127700834043275786e+03,1.99968818079062839385e+03,4.04245965542611429555e+02,2.04013911806308237818e+03,1.63400000000000017452e-01,3.86166666666666671394e+01,300.0,NULL);
INSERT INTO "peak" VALUES(16,1,'car_body_acceleration','car_body','m/s^2',1.36885404736988435143e-03,1.14008434724116570167e-03,-1.36885404736988435143e-03,1.15082906749484908145e-05,7.86378786251072181903e-04,7.86462991004642638856e-04,0.0753,31.275,300.0,NULL);
INSERT INTO "peak" VALUES(17,1,'bogie_acceleration','bogie_1','m/s^2',1.2088327355392053386e-01,1.2088327355392053386e-01,-1.02394139718965021534e-01,1.1514264133570045398e-03,0.0611364588326911,6.11473006876567665157e-02,0.125,3.54166666666666714031e+01,300.0,NULL);
INSERT INTO "peak" VALUES(18,1,'bogie_acceleration','bogie_2','m/s^2',1.94378606622161637096e-01,1.62275421760430388351e-01,-1.94378606622161637096e-01,-3.73778840294210798304e-04,1.06397444990411663146e-01,1.06398101539027123418e-01,0.049,2.90833333333333357009e+01,300.0,NULL);
INSERT INTO "peak" VALUES(19,1,'wheelset_acceleration','wheelset_1','m/s^2',3.54246274891969292752e+01,3.48454800012496050958e+01,-3.54246274891969292752e+01,9.92107438138992853149e-02,2.45897388417631610488e+01,2.45899389807661776789e+01,0.1274,3.56166666666666671399e+01,300.0,NULL);
INSERT INTO "peak" VALUES(20,1,'wheelset_acceleration','wheelset_2','m/s^2',3.41623280320172497672e+01,3.35210428226563408307e+01,-3.41623280320172497672e+01,-0.0993221684260593,2.36829010900161875943e+01,2.36831093594703219191e+01,2.54000000000000024369e-02,2.71166666666666671407e+01,300.0,NULL);
INSERT INTO "peak" VALUES(21,1,'wheelset_acceleration','wheelset_3','m/s^2',2.92014010504380507873e+01,2.87185456656607200898e+01,-2.92014010504380507873e+01,2.93188281155975449809e-01,2.01385767094214038772e+01,2.01407107930543851628e+01,0.0477,2.89749999999999978683e+01,300.0,NULL);
INSERT INTO "peak" VALUES(22,1,'wheelset_acceleration','wheelset_4','m/s^2',2.74037928402462043213e+01,2.6900762306932691104e+01,-2.74037928402462043213e+01,-2.50543121393872969537e-01,18.890501631662,1.88921630246910154937e+01,0.0779,3.14916666666666671407e+01,300.0,NULL);
INSERT INTO "peak" VALUES(23,1,'wheel_rail_force_20hz','wheelset_1','N',7.03341420213597884845e+04,7.03341420213597884845e+04,6.3202093299000422122e+04,6.84634764184152445508e+04,1.27644730805449330547e+03,6.84753745592175691852e+04,0.2,4.16666666666666642973e+01,300.0,NULL);
INSERT INTO "peak" VALUES(24,1,'wheel_unloading','wheelset_1','1',6.13627414816311111955e-01,6.13627414816311111955e-01,-6.23407842098085196447e-01,2.52624155284958710684e-03,4.32597168943537946361e-01,4.32604545138336737952e-01,0.1096,3.41333333333333328592e+01,300.0,NULL);
INSERT INTO "peak" VALUES(25,1,'contact_loss','wheelset_1','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(26,1,'wheel_rail_force_20hz','wheelset_2','N',7.39495029836368194088e+04,7.39495029836368194088e+04,6.71313189188068208754e+04,6.88736148850895406195e+04,1.2281853381931273361e+03,6.88845647918645263407e+04,0.0004,2.50333333333333314381e+01,300.0,NULL);
INSERT INTO "peak" VALUES(27,1,'wheel_unloading','wheelset_2','1',5.89820118235727219868e-01,5.89820118235727219868e-01,-6.01139363783874891566e-01,-2.49737257642074607713e-03,4.16599603906229520866e-01,4.16607089287511778152e-01,0.1395,36.625,300.0,NULL);
INSERT INTO "peak" VALUES(28,1,'contact_loss','wheelset_2','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(29,1,'wheel_rail_force_20hz','wheelset_3','N',6.93438131912487879145e+04,6.93438131912487879145e+04,6.37961628862807629027e+04,6.83635130297674477317e+04,1.07632915746416324507e+03,68371.9854781649,0.166,3.88333333333333357018e+01,300.0,NULL);
INSERT INTO "peak" VALUES(30,1,'wheel_unloading','wheelset_3','1',0.505409501244608,0.505409501244608,-5.14232046543161680496e-01,4.63086713138454505317e-03,3.5461272924750736335e-01,3.54642965071569560286e-01,1.6190000000000001612e-01,3.84916666666666671412e+01,300.0,NULL);
INSERT INTO "peak" VALUES(31,1,'contact_loss','wheelset_3','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(32,1,'wheel_rail_force_20hz','wheelset_4','N',7.30082575276560237411e+04,7.30082575276560237411e+04,6.80699489463251084095e+04,68924.632146822,9.6307364334915973817e+02,6.89313602608946093819e+04,0.2,4.16666666666666642973e+01,300.0,NULL);
INSERT INTO "peak" VALUES(33,1,'wheel_unloading','wheelset_4','1',4.73338527664069697031e-01,4.73338527664069697031e-01,-4.82190589764182830911e-01,-3.89499336280059622883e-03,3.32596367561082795205e-01,3.32619173662798861546e-01,0.1681,3.90083333333333328587e+01,300.0,NULL);
INSERT INTO "peak" VALUES(34,1,'contact_loss','wheelset_4','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(35,1,'car_body_acceleration_comfort','car_body','m/s^2',2.40900924846883674737e-04,-3.98772469165425554292e-05,-2.40900924846883674737e-04,-9.10362413464259855044e-05,5.67133690605574957224e-05,1.0725671759234346118e-04,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(36,1,'wheel_rail_force_quantile','wheelset_1','N',1.1140813274445879506e+05,1.1140813274445879506e+05,1.1140813274445879506e+05,1.1140813274445879506e+05,0.0,1.1140813274445879506e+05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(37,1,'contact_loss_events','wheelset_1','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(38,1,'contact_loss_duration','wheelset_1','s',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(39,1,'wheel_rail_force_quantile','wheelset_2','N',1.09924530998618269223e+05,1.09924530998618269223e+05,1.09924530998618269223e+05,1.09924530998618269223e+05,0.0,1.09924530998618269223e+05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(40,1,'contact_loss_events','wheelset_2','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(41,1,'contact_loss_duration','wheelset_2','s',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(42,1,'wheel_rail_force_quantile','wheelset_3','N',1.03950938439437988566e+05,1.03950938439437988566e+05,1.03950938439437988566e+05,1.03950938439437988566e+05,0.0,1.03950938439437988566e+05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(43,1,'contact_loss_events','wheelset_3','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(44,1,'contact_loss_duration','wheelset_3','s',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(45,1,'wheel_rail_force_quantile','wheelset_4','N',1.01737070092581459901e+05,1.01737070092581459901e+05,1.01737070092581459901e+05,1.01737070092581459901e+05,0.0,1.01737070092581459901e+05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(46,1,'contact_loss_events','wheelset_4','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(47,1,'contact_loss_duration','wheelset_4','s',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(48,1,'sperling_index','car_body','1',2.33454525239745469544e-01,2.33454525239745469544e-01,2.33454525239745469544e-01,2.33454525239745469544e-01,0.0,2.33454525239745469544e-01,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(49,1,'wheel_rail_force_20hz_quantile','wheelset_1','N',7.03332795728635537654e+04,7.03332795728635537654e+04,7.03332795728635537654e+04,7.03332795728635537654e+04,0.0,7.03332795728635537654e+04,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(50,1,'wheel_rail_force_20hz_quantile','wheelset_2','N',73948.947830962,73948.947830962,73948.947830962,73948.947830962,0.0,73948.947830962,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(51,1,'wheel_rail_force_20hz_quantile','wheelset_3','N',6.93436006201821874108e+04,6.93436006201821874108e+04,6.93436006201821874108e+04,6.93436006201821874108e+04,0.0,6.93436006201821874108e+04,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(52,1,'wheel_rail_force_20hz_quantile','wheelset_4','N',7.30061852157311514006e+04,7.30061852157311514006e+04,7.30061852157311514006e+04,7.30061852157311514006e+04,0.0,7.30061852157311514006e+04,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(53,2,'wheel_rail_force','wheelset_1','N',1.10412460267177288191e+05,1.10412460267177288191e+05,2.73904511322518374061e+04,6.85081964025204215437e+04,2.888486534132194356e+04,7.43485603096160484713e+04,0.0195,26.625,300.0,NULL);
INSERT INTO "peak" VALUES(54,2,'wheel_rail_force','wheelset_2','N',1.09280074984521241273e+05,1.09280074984521241273e+05,2.83178334471054695305e+04,6.8843911200235117574e+04,2.81201662925898672245e+04,7.43655018248970445726e+04,0.0495,29.125,300.0,NULL);
INSERT INTO "peak" VALUES(55,2,'wheel_rail_force','wheelset_3','N',1.04833265847148533799e+05,1.04833265847148533799e+05,3.30346873420450210683e+04,6.83204458110144769323e+04,2.4789948940597056207e+04,7.26789163670811394707e+04,0.0717,30.975,300.0,NULL);
INSERT INTO "peak" VALUES(56,2,'wheel_rail_force','wheelset_4','N',1.02270012619767425353e+05,1.02270012619767425353e+05,3.52281562503820605352e+04,6.89719527366213587798e+04,2.28964232895215318431e+04,7.26730793606248334998e+04,0.1018,3.34833333333333342811e+01,300.0,NULL);
INSERT INTO "peak" VALUES(57,2,'rail_displacement','wheelset_1','m',1.36595184894052574728e-03,1.36595184894052574728e-03,6.14307672101854882092e-04,9.85565622063163879196e-04,2.60518623220852964337e-04,1.01941627828755032418e-03,0.0206,2.67166666666666650096e+01,300.0,NULL);
INSERT INTO "peak" VALUES(58,2,'rail_acceleration','wheelset_1','m/s^2',1.31656286643993780671e+02,9.91033740756669345728e+01,-1.31656286643993780671e+02,-1.27762308383103739828e+01,7.95713485413016883293e+01,8.05905179479267701463e+01,0.1285,3.57083333333333357022e+01,300.0,NULL);
INSERT INTO "peak" VALUES(59,2,'rail_acceleration_moving_frame','wheelset_1','m/s^2',1.02897799404100211975e+02,1.01047497584443206623e+02,-1.02897799404100211975e+02,1.21258134140311280013e+00,7.14543617671769197823e+01,7.14646497861992884264e+01,0.1285,3.57083333333333357022e+01,300.0,NULL);
INSERT INTO "peak" VALUES(60,2,'slab_displacement','wheelset_1','m',5.10421356492611307323e-04,5.10421356492611307323e-04,3.84527830075029938144e-04,4.417906020303646983e-04,3.26815056321896766017e-05,4.4299776167915219183e-04,0.0954,32.95,300.0,NULL);
INSERT INTO "peak" VALUES(61,2,'slab_acceleration','wheelset_1','m/s^2',1.72739142180276026294e+01,1.5015699730324190142e+01,-1.72739142180276026294e+01,-6.43541726044527528927e-01,9.22415739345914,9.2465791281136660018e+00,0.0952,3.29333333333333300174e+01,300.0,NULL);
INSERT INTO "peak" VALUES(62,2,'base_displacement','wheelset_1','m',4.71708692434880745743e-04,4.71708692434880745743e-04,3.36031951634867460422e-04,4.04426562160550742263e-04,4.10194236179270879747e-05,4.06501460384767611226e-04,2.43000000000000021538e-02,2.70250000000000021324e+01,300.0,NULL);
INSERT INTO "peak" VALUES(63,2,'base_acceleration','wheelset_1','m/s^2',1.83800255192790515934e+01,1.76014889242538714593e+01,-1.83800255192790515934e+01,-4.32449785045782741921e-01,1.15683770546820792186e+01,1.15764571651209831055e+01,2.43000000000000021538e-02,2.70250000000000021324e+01,300.0,NULL);
INSERT INTO "peak" VALUES(64,2,'slab_moment','wheelset_1','N m',7.64825458409980637932e+03,7.64825458409980637932e+03,6.33247817967665156419e+01,3.08726255766817621415e+03,1.85324188090368852498e+03,3.60079096437370117203e+03,0.1291,3.57583333333333328605e+01,300.0,NULL);
INSERT INTO "peak" VALUES(65,2,'roadbed_pressure','wheelset_1','N/m',3.01759807784811127928e+04,3.01759807784811127928e+04,1.99086571402339832272e+04,2.50074313853458879744e+04,3.12076324625931056291e+03,2.52014044793536340881e+04,2.31000000000000024757e-02,2.69249999999999971582e+01,300.0,NULL);
INSERT INTO "peak" VALUES(66,2,'pad_force','pads','N',4.85884655259001156093e+04,4.85884655259001156093e+04,3.18438387740517428025e+04,4.17074938760031145666e+04,3.72377896053560880325e+03,4.18733993743494138477e+04,0.1515,37.625,300.0,NULL);
INSERT INTO "peak" VALUES(67,2,'pad_uplift','pads','N',2763.0306441141,2763.0306441141,1.11487584188398545852e+03,2.02916976833483954584e+03,401.71541707579,2.06855147991062631265e+03,0.079,3.1583333333333332149e+01,300.0,NULL);
INSERT INTO "peak" VALUES(68,2,'car_body_acceleration','car_body','m/s^2',1.96118906461746709407e-03,1.96118906461746709407e-03,-1.57594712697808024548e-03,-4.41556324735591212765e-05,8.85944154984597150546e-04,8.87043835236180468542e-04,0.1051,3.375833333333333286e+01,300.0,NULL);
INSERT INTO "peak" VALUES(69,2,'bogie_acceleration','bogie_1','m/s^2',1.31956015304963147904e-01,1.31956015304963147904e-01,-1.17240896065650579416e-01,-2.53547785812713094219e-04,5.27357270052731530451e-02,5.27363365171907572115e-02,1.71700000000000019273e-01,3.93083333333333300174e+01,300.0,NULL);
INSERT INTO "peak" VALUES(70,2,'bogie_acceleration','bogie_2','m/s^2',2.48176767870510822655e-01,2.29321487487656544557e-01,-2.48176767870510822655e-01,-1.79616175794606561418e-03,1.21374900858332801512e-01,1.21388190345810914605e-01,0.158,3.81666666666666642981e+01,300.0,NULL);
INSERT INTO "peak" VALUES(71,2,'wheelset_acceleration','wheelset_1','m/s^2',3.46175526780663105346e+01,3.40937371398168664882e+01,-3.46175526780663105346e+01,9.26023502844380425047e-02,2.39099203494710437216e+01,2.39100996717564484583e+01,0.0193,2.66083333333333342811e+01,300.0,NULL);
INSERT INTO "peak" VALUES(72,2,'wheelset_acceleration','wheelset_2','m/s^2',3.36908376843232275636e+01,3.33404379672416553139e+01,-3.36908376843232275636e+01,-1.01951036779796430642e-01,2.32787891383655214387e+01,2.32790123880371027089e+01,4.93000000000000035416e-02,2.91083333333333307271e+01,300.0,NULL);
INSERT INTO "peak" VALUES(73,2,'wheelset_acceleration','wheelset_3','m/s^2',3.0010350265965985983e+01,2.94263279053685877784e+01,-3.0010350265965985983e+01,3.18638301877307406062e-01,2.05011963028761314822e+01,20.5036723592747,0.0716,3.0966666666666668561e+01,300.0,NULL);
INSERT INTO "peak" VALUES(74,2,'wheelset_acceleration','wheelset_4','m/s^2',2.78897293666310197579e+01,2.7630820165333922489e+01,-2.78897293666310197579e+01,-2.76242534267364947542e-01,1.89381316643824071377e+01,1.89401462738602432978e+01,0.1017,33.475,300.0,NULL);
INSERT INTO "peak" VALUES(75,2,'joint_opening','joints','m',5.31621295499431e-05,5.13737742845309249516e-05,-5.31621295499431e-05,-2.70919139288726062856e-08,2.82472404066112873491e-05,2.82472533985287453765e-05,0.1351,3.625833333333333286e+01,300.0,NULL);
INSERT INTO "peak" VALUES(76,2,'joint_slope_jump','joints','rad',3.17000247580247434923e-04,2.93364331783723438894e-04,-3.17000247580247434923e-04,4.86864335761286754107e-05,1.88523985889033345465e-04,1.94709173050093401792e-04,1.76500000000000017985e-01,3.97083333333333357009e+01,300.0,NULL);
INSERT INTO "peak" VALUES(77,2,'joint_shear','joints','N',5.66911909684574584402e+03,5.34794047321628568175e+03,-5.66911909684574584402e+03,-1.8849431769664633407e+01,2.98196130454435069613e+03,2.98202087901441200302e+03,1.34400000000000019451e-01,3.61999999999999957358e+01,300.0,NULL);
INSERT INTO "peak" VALUES(78,2,'slab_moment','joints','N m',5.66202037765085333361e+03,5.66202037765085333361e+03,-2.3822900615519829444e+03,2.4809937264916516143e+03,1.67420929209362702753e+03,2.99304303754950569785e+03,1.02600000000000010635e-01,33.55,300.0,NULL);
INSERT INTO "peak" VALUES(79,2,'wheel_rail_force_20hz','wheelset_1','N',7.02939334067536692601e+04,7.02939334067536692601e+04,6.33461399172678065946e+04,6.84759719478529732452e+04,1.24161563931040291213e+03,6.8487227594632029649e+04,0.2,4.16666666666666642973e+01,300.0,NULL);
INSERT INTO "peak" VALUES(80,2,'wheel_unloading','wheelset_1','1',6.01129297622661429301e-01,6.01129297622661429301e-01,-6.0787039853177937676e-01,2.35624868908664367173e-03,0.420632959681403,4.20639559098073434473e-01,8.56000000000000094146e-02,3.21333333333333328587e+01,300.0,NULL);
INSERT INTO "peak" VALUES(81,2,'contact_loss','wheelset_1','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(82,2,'wheel_rail_force_20hz','wheelset_2','N',7.39435993501499324318e+04,7.39435993501499324318e+04,6.72611015282853186379e+04,6.88757240666859433999e+04,1.21610873983116016456e+03,68886.4593819232,0.0004,2.50333333333333314381e+01,300.0,NULL);
INSERT INTO "peak" VALUES(83,2,'wheel_unloading','wheelset_2','1',5.87624385508876190264e-01,5.87624385508876190264e-01,-5.91380151223550920569e-01,-2.53256444204339294448e-03,4.09497106343233885361e-01,4.09504937682239555929e-01,0.0436,2.86333333333333328596e+01,300.0,NULL);
INSERT INTO "peak" VALUES(84,2,'contact_loss','wheelset_2','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(85,2,'wheel_rail_force_20hz','wheelset_3','N',6.93584505645366298284e+04,6.93584505645366298284e+04,6.37349696310953804656e+04,68329.9331395317,1.09971020373878400279e+03,68338.7820010357,0.1653,38.775,300.0,NULL);
INSERT INTO "peak" VALUES(86,2,'wheel_unloading','wheelset_3','1',5.18935672898718225454e-01,5.18935672898718225454e-01,-5.26623938359524257357e-01,5.09034788096005604701e-03,3.61001149564541434777e-01,3.61037036366727348557e-01,0.1139,3.44916666666666671403e+01,300.0,NULL);
INSERT INTO "peak" VALUES(87,2,'contact_loss','wheelset_3','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(88,2,'wheel_rail_force_20hz','wheelset_4','N',7.3060480342353068409e+04,7.3060480342353068409e+04,6.80526492244265537e+04,6.89608686018947337299e+04,9.74560485039234095008e+02,6.89677545412839390322e+04,0.2,4.16666666666666642973e+01,300.0,NULL);
INSERT INTO "peak" VALUES(89,2,'wheel_unloading','wheelset_4','1',4.8699350152348824805e-01,4.8699350152348824805e-01,-4.89296819859726617174e-01,-4.39715649659769888119e-03,3.33426871843913397164e-01,3.33455864924989742181e-01,0.096,33.0,300.0,NULL);
INSERT INTO "peak" VALUES(90,2,'contact_loss','wheelset_4','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(91,2,'car_body_acceleration_comfort','car_body','m/s^2',2.77127032635821079521e-04,5.12928764990402478139e-05,-2.77127032635821079521e-04,-2.52305728046947765714e-05,8.42804423582624599644e-05,8.79759897253643e-05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(92,2,'wheel_rail_force_quantile','wheelset_1','N',1.10367057747751881829e+05,1.10367057747751881829e+05,1.10367057747751881829e+05,1.10367057747751881829e+05,0.0,1.10367057747751881829e+05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(93,2,'contact_loss_events','wheelset_1','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(94,2,'contact_loss_duration','wheelset_1','s',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(95,2,'wheel_rail_force_quantile','wheelset_2','N',1.0924976274710932921e+05,1.0924976274710932921e+05,1.0924976274710932921e+05,1.0924976274710932921e+05,0.0,1.0924976274710932921e+05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(96,2,'contact_loss_events','wheelset_2','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(97,2,'contact_loss_duration','wheelset_2','s',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(98,2,'wheel_rail_force_quantile','wheelset_3','N',1.04666857192794239377e+05,1.04666857192794239377e+05,1.04666857192794239377e+05,1.04666857192794239377e+05,0.0,1.04666857192794239377e+05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(99,2,'contact_loss_events','wheelset_3','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(100,2,'contact_loss_duration','wheelset_3','s',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(101,2,'wheel_rail_force_quantile','wheelset_4','N',1.02148917056873397087e+05,1.02148917056873397087e+05,1.02148917056873397087e+05,1.02148917056873397087e+05,0.0,1.02148917056873397087e+05,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(102,2,'contact_loss_events','wheelset_4','1',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(103,2,'contact_loss_duration','wheelset_4','s',0.0,0.0,0.0,0.0,0.0,0.0,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(104,2,'sperling_index','car_body','1',2.75601592800990891074e-01,2.75601592800990891074e-01,2.75601592800990891074e-01,2.75601592800990891074e-01,0.0,2.75601592800990891074e-01,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(105,2,'wheel_rail_force_20hz_quantile','wheelset_1','N',7.02931933186280366501e+04,7.02931933186280366501e+04,7.02931933186280366501e+04,7.02931933186280366501e+04,0.0,7.02931933186280366501e+04,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(106,2,'wheel_rail_force_20hz_quantile','wheelset_2','N',7.3942816183906426887e+04,7.3942816183906426887e+04,7.3942816183906426887e+04,7.3942816183906426887e+04,0.0,7.3942816183906426887e+04,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(107,2,'wheel_rail_force_20hz_quantile','wheelset_3','N',69358.2774136908,69358.2774136908,69358.2774136908,69358.2774136908,0.0,69358.2774136908,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(108,2,'wheel_rail_force_20hz_quantile','wheelset_4','N',73058.606516579,73058.606516579,73058.606516579,73058.606516579,0.0,73058.606516579,0.0001,2.50083333333333364119e+01,300.0,NULL);
INSERT INTO "peak" VALUES(109,3,'wheel_rail_force','wheelset_1','N',73161.5999940933,73161.5999940933,6.42827869701265808537e+04,6.88928802232883463144e+04,1.4995562960420677428e+03,6.89091983304504537974e+04,7.76680851063829905123e-03,2.13739361702127688151e+01,250.0,25.0);
INSERT INTO "peak" VALUES(110,3,'wheel_rail_force','wheelset_2','N',73183.4128371613,73183.4128371613,6.5396691625264327741e+04,6.87334504157414776263e+04,1.53101861467186427037e+03,6.87504998094680340719e+04,4.431063829787234426e-02,2.39117021276595735916e+01,250.0,25.0);
INSERT INTO "peak" VALUES(111,3,'wheel_rail_force','wheelset_3','N',7.29753539997081243206e+04,7.29753539997081243206e+04,6.42069410737229554798e+04,6.85941448098422115438e+04,2.17076174122165775778e+03,6.86284846745923277902e+04,1.08536170212765972764e-01,2.83718085106383028914e+01,250.0,25.0);
INSERT INTO "peak" VALUES(112,3,'wheel_rail_force','wheelset_4','N',7.32085127254687686223e+04,7.32085127254687686223e+04,6.40459075555748131572e+04,6.87575256480320240373e+04,2.25378703446895724488e+03,6.87944539133535145096e+04,2.23046808510638308598e-02,2.23835106382978743511e+01,250.0,25.0);
INSERT INTO "peak" VALUES(113,3,'rail_displacement','wheelset_1','m',9.73639101070142482831e-04,9.73639101070142482831e-04,8.71861589580876449566e-04,9.22850440434678435767e-04,2.03346349740023726567e-05,9.23074445963057679982e-04,1.30442553191489375719e-02,2.17404255319148944627e+01,250.0,25.0);
INSERT INTO "peak" VALUES(114,3,'rail_acceleration','wheelset_1','m/s^2',1.29574879572493379949e+01,-7.1232407056528792566e+00,-1.29574879572493379949e+01,-9.54060452315090223862e+00,1.21126442186614768914e+00,9.6171875393405,8.36425531914893743978e-03,2.14154255319148951737e+01,250.0,25.0);
INSERT INTO "peak" VALUES(115,3,'rail_acceleration_moving_frame','wheelset_1','m/s^2',1.77644752303933306514e+00,1.25242309280394770176e+00,-1.77644752303933306514e+00,-4.93338625134803823724e-02,4.83233067814579586585e-01,4.8574481759457721619e-01,1.01565957446808526054e-02,2.15398936170212778056e+01,250.0,25.0);
INSERT INTO "peak" VALUES(116,3,'slab_displacement','wheelset_1','m',4.72177664800132372655e-04,4.72177664800132372655e-04,4.13961185516264422012e-04,4.40642459447339264379e-04,1.24527876622016674752e-05,4.40818385492665126227e-04,1.52348936170212789081e-02,2.18925531914893625176e+01,250.0,25.0);
INSERT INTO "peak" VALUES(117,3,'slab_acceleration','wheelset_1','m/s^2',1.54128342929969286423e+00,0.436134660542726,-1.54128342929969286423e+00,-6.05272315569164165438e-01,0.374025223037533,7.1151208244325281349e-01,1.94170212765957458933e-02,2.21829787234042576917e+01,250.0,25.0);
INSERT INTO "peak" VALUES(118,3,'base_displacement','wheelset_1','m',4.33717292859086124643e-04,4.33717292859086124643e-04,3.77337086856455508881e-04,4.03598898240321878917e-04,1.18024059070194895968e-05,4.03771429704970262562e-04,1.46374468085106405196e-02,2.1851063829787236159e+01,250.0,25.0);
INSERT INTO "peak" VALUES(119,3,'base_acceleration','wheelset_1','m/s^2',1.37110951126397262456e+00,8.06690623706797893532e-01,-1.37110951126397262456e+00,-3.94516638532670327332e-01,4.09494416703121200118e-01,5.68620308633227766748e-01,2.10102127659574505758e-02,22.2936170212766,250.0,25.0);
INSERT INTO "peak" VALUES(120,3,'slab_moment','wheelset_1','N m',5.41706294847384742761e+03,5.41706294847384742761e+03,2.86306339560520837026e+03,3.96839585382542054513e+03,7.09155725124748528278e+02,4.03126127845070323036e+03,8.76255319148936187567e-03,2.14430851063829805988e+01,250.0,25.0);
INSERT INTO "peak" VALUES(121,3,'roadbed_pressure','wheelset_1','N/m',2.67733952412171311149e+04,2.67733952412171311149e+04,23143.0757361347,2.48511341143347744947e+04,753.594897650173,2.48625576326816772059e+04,1.29446808510638305955e-02,2.1733510638297875773e+01,250.0,25.0);
INSERT INTO "peak" VALUES(122,3,'pad_force','pads','N',3.08299485865574897608e+04,3.08299485865574897608e+04,2.65080211487682754515e+04,2.8966778611331261346e+04,8.98851916381992623386e+02,2.89807211415703386584e+04,4.431063829787234426e-02,2.39117021276595735916e+01,250.0,25.0);
INSERT INTO "peak" VALUES(123,3,'pad_uplift','pads','N',1.18772517058219796129e+03,1.18772517058219796129e+03,9.85446046154685177491e+02,1.1013631277626848259e+03,3.99907552748325443312e+01,1.10208892549678375873e+03,4.18212765957446871989e-03,21.125,250.0,25.0);
INSERT INTO "peak" VALUES(124,3,'car_body_acceleration','car_body','m/s^2',2.8166047281719851919e-02,2.27474843412770189043e-02,-2.8166047281719851919e-02,-1.50567565247988820013e-03,1.43159894025327878025e-02,1.43949509114794076819e-02,0.0668144680851064,2.54744680851063876048e+01,250.0,25.0);
INSERT INTO "peak" VALUES(125,3,'bogie_acceleration','bogie_1','m/s^2',6.81435212307752502525e-01,4.77087158969710878331e-01,-6.81435212307752502525e-01,-6.19738507907754768155e-02,2.78656416831039366321e-01,2.85464808379161272267e-01,5.46663829787234073487e-02,2.46308510638297910593e+01,250.0,25.0);
INSERT INTO "peak" VALUES(126,3,'bogie_acceleration','bogie_2','m/s^2',7.28082312966721878488e-01,5.40345172904206472175e-01,-7.28082312966721878488e-01,2.57775429633343069329e-03,2.9340226414068970584e-01,2.93413587654176799546e-01,1.56829787234042561383e-01,3.17255319148936223419e+01,250.0,25.0);
INSERT INTO "peak" VALUES(127,3,'wheelset_acceleration','wheelset_1','m/s^2',3.41550883328441079456e+00,3.22574404191877261993e+00,-3.41550883328441079456e+00,-8.26213103780615576443e-02,1.12199325762593615785e+00,1.12503117782870720731e+00,7.66723404255319207489e-03,2.13670212765957465714e+01,250.0,25.0);
INSERT INTO "peak" VALUES(128,3,'wheelset_acceleration','wheelset_2','m/s^2',3.60613254149546236249e+00,2.22055115595658669747e+00,-3.60613254149546236249e+00,-6.80909148848952427979e-02,1.10551660371399962379e+00,1.10761154462076594207e+00,4.40119148936170268004e-02,2.38909574468085139642e+01,250.0,25.0);
INSERT INTO "peak" VALUES(129,3,'wheelset_acceleration','wheelset_3','m/s^2',3.72936402370741770795e+00,3.72936402370741770795e+00,-3.1420335542680852825e+00,5.44637818882895835548e-02,1.60777705496504363935e+00,1.60869927643722276933e+00,1.31836595744680873387e-01,2.99898936170212770946e+01,250.0,25.0);
INSERT INTO "peak" VALUES(130,3,'wheelset_acceleration','wheelset_4','m/s^2',3.38361619073023422998e+00,3.38361619073023422998e+00,-2.99968856978050624206e+00,-0.0477964146075968,1.6319257008272,1.63262548989953293343e+00,1.11324255319148954224e-01,2.85654255319148973066e+01,250.0,25.0);
INSERT INTO "peak" VALUES(131,3,'wheel_rail_force_20hz','wheelset_1','N',7.18580096636510133991e+04,7.18580096636510133991e+04,6.69545103134862147273e+04,6.88954507751348573961e+04,1.09050071958103285397e+03,6.89040806435180420508e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(132,3,'wheel_unloading','wheelset_1','1',6.38883505151218722417e-02,6.38883505151218722417e-02,-6.54084752307164118967e-02,-3.24567093764892159249e-03,0.0218371384307859,2.20770241355307053621e-02,2.00045106382978732373e-01,3.47265957446808570807e+01,250.0,25.0);
INSERT INTO "peak" VALUES(133,3,'contact_loss','wheelset_1','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(134,3,'wheel_rail_force_20hz','wheelset_2','N',7.04808334145764383725e+04,7.04808334145764383725e+04,6.70365723956287838528e+04,6.87333191816150210814e+04,9.06474741793127805102e+02,6.87392963462623447432e+04,4.94885106382978792738e-02,2.42712765957446841014e+01,250.0,25.0);
INSERT INTO "peak" VALUES(135,3,'wheel_unloading','wheelset_2','1',4.76672254949129514667e-02,4.76672254949129514667e-02,-6.57261225740687904384e-02,-9.23990326801759883149e-04,2.22953052959351111228e-02,2.23144436713751739831e-02,2.1508085106382981988e-02,2.23281914893617070569e+01,250.0,25.0);
INSERT INTO "peak" VALUES(136,3,'contact_loss','wheelset_2','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(137,3,'wheel_rail_force_20hz','wheelset_3','N',7.15234820374460396113e+04,7.15234820374460396113e+04,6.58409128176407393772e+04,6.8594639973726385506e+04,1.56345577025375200722e+03,68612.4553348055,1.08635744680851076271e-01,2.83787234042553215829e+01,250.0,25.0);
INSERT INTO "peak" VALUES(138,3,'wheel_unloading','wheelset_3','1',6.49928487880740424209e-02,6.49928487880740424209e-02,-6.26962865837792926448e-02,1.10463361231677307042e-03,3.16115005274742663643e-02,3.16307948211227499268e-02,7.5377872340425533526e-02,2.60691489361702153368e+01,250.0,25.0);
INSERT INTO "peak" VALUES(139,3,'contact_loss','wheelset_3','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(140,3,'wheel_rail_force_20hz','wheelset_4','N',7.14421199607635644488e+04,7.14421199607635644488e+04,6.58499363938758615387e+04,6.87493286581195570767e+04,1.5663106620074072452e+03,6.87671689109858416504e+04,1.4488085106382980749e-01,3.08957446808510667319e+01,250.0,25.0);
INSERT INTO "peak" VALUES(141,3,'wheel_unloading','wheelset_4','1',6.73378832739942728702e-02,6.73378832739942728702e-02,-0.0660916371846333,-1.27458348670467843527e-03,3.28205480481863556829e-02,3.28452879002131686858e-02,1.1202127659574469265e-01,2.86138297872340459093e+01,250.0,25.0);
INSERT INTO "peak" VALUES(142,3,'contact_loss','wheelset_4','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(143,3,'car_body_acceleration_comfort','car_body','m/s^2',2.56685346278427324595e-02,2.56685346278427324595e-02,-1.92253400531964650788e-02,0.00358359911083084,1.18797872445625361803e-02,1.24085264057912335322e-02,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(144,3,'wheel_rail_force_quantile','wheelset_1','N',7.31514052517797827004e+04,7.31514052517797827004e+04,7.31514052517797827004e+04,7.31514052517797827004e+04,0.0,7.31514052517797827004e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(145,3,'contact_loss_events','wheelset_1','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(146,3,'contact_loss_duration','wheelset_1','s',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(147,3,'wheel_rail_force_quantile','wheelset_2','N',7.31748511441521259273e+04,7.31748511441521259273e+04,7.31748511441521259273e+04,7.31748511441521259273e+04,0.0,7.31748511441521259273e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(148,3,'contact_loss_events','wheelset_2','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(149,3,'contact_loss_duration','wheelset_2','s',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(150,3,'wheel_rail_force_quantile','wheelset_3','N',7.29633471323703270165e+04,7.29633471323703270165e+04,7.29633471323703270165e+04,7.29633471323703270165e+04,0.0,7.29633471323703270165e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(151,3,'contact_loss_events','wheelset_3','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(152,3,'contact_loss_duration','wheelset_3','s',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(153,3,'wheel_rail_force_quantile','wheelset_4','N',7.32032862021132896181e+04,7.32032862021132896181e+04,7.32032862021132896181e+04,7.32032862021132896181e+04,0.0,7.32032862021132896181e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(154,3,'contact_loss_events','wheelset_4','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(155,3,'contact_loss_duration','wheelset_4','s',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(156,3,'sperling_index','car_body','1',9.23441255591021414872e-01,9.23441255591021414872e-01,9.23441255591021414872e-01,9.23441255591021414872e-01,0.0,9.23441255591021414872e-01,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(157,3,'wheel_rail_force_20hz_quantile','wheelset_1','N',7.18568440252505242831e+04,7.18568440252505242831e+04,7.18568440252505242831e+04,7.18568440252505242831e+04,0.0,7.18568440252505242831e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(158,3,'wheel_rail_force_20hz_quantile','wheelset_2','N',7.04806322992041241366e+04,7.04806322992041241366e+04,7.04806322992041241366e+04,7.04806322992041241366e+04,0.0,7.04806322992041241366e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(159,3,'wheel_rail_force_20hz_quantile','wheelset_3','N',7.15230614926639100305e+04,7.15230614926639100305e+04,7.15230614926639100305e+04,7.15230614926639100305e+04,0.0,7.15230614926639100305e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(160,3,'wheel_rail_force_20hz_quantile','wheelset_4','N',7.14416880205550696705e+04,7.14416880205550696705e+04,7.14416880205550696705e+04,7.14416880205550696705e+04,0.0,7.14416880205550696705e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,25.0);
INSERT INTO "peak" VALUES(161,4,'wheel_rail_force','wheelset_1','N',1.02546961528020459805e+05,1.02546961528020459805e+05,3.52748621350471294137e+04,6.90868712879058293786e+04,8.73143858390047353148e+03,6.96364402026416792063e+04,3.6842553191489364403e-03,2.10904255319148958847e+01,250.0,NULL);
INSERT INTO "peak" VALUES(162,4,'wheel_rail_force','wheelset_2','N',1.19456138745862510406e+05,1.19456138745862510406e+05,1.27368674613616658457e+04,6.91719667305512848562e+04,1.47239107460827653994e+04,7.07216694445988396187e+04,4.08255319148936174356e-03,2.11180851063829777558e+01,250.0,NULL);
INSERT INTO "peak" VALUES(163,4,'wheel_rail_force','wheelset_3','N',1.24408491936830934722e+05,1.24408491936830934722e+05,1.33087727692381322416e+04,68781.7607350693,3.24472772753209501381e+04,7.60510119090987573133e+04,1.82619574468085132945e-01,3.35164893617021277796e+01,250.0,NULL);
INSERT INTO "peak" VALUES(164,4,'wheel_rail_force','wheelset_4','N',1.20525875350628310111e+05,1.20525875350628310111e+05,8.04812993697580441199e+03,6.89332383409561880388e+04,3.13981395231804744972e+04,7.57471749551637185508e+04,2.00045106382978732373e-01,3.47265957446808570807e+01,250.0,NULL);
INSERT INTO "peak" VALUES(165,4,'rail_displacement','wheelset_1','m',1.10482606357356866015e-03,1.10482606357356866015e-03,7.54799880499606935975e-04,0.000921464357076382,4.385540219512033361e-05,9.22507375398097192488e-04,4.87914893617021321742e-03,2.11734042553191521558e+01,250.0,NULL);
INSERT INTO "peak" VALUES(166,4,'rail_acceleration','wheelset_1','m/s^2',4.7191105037565627355e+01,2.84007981691199695717e+01,-4.7191105037565627355e+01,-9.64229117495656495862e+00,8.03183977715664276786e+00,1.25492720628951559547e+01,5.27744680851063852067e-03,2.1201063829787237581e+01,250.0,NULL);
INSERT INTO "peak" VALUES(167,4,'rail_acceleration_moving_frame','wheelset_1','m/s^2',3.77796160524423498818e+01,3.37406250861119900714e+01,-3.77796160524423498818e+01,-1.6540982479742166733e-01,7.24560190864678865807e+00,7.24748973291618447944e+00,5.27744680851063852067e-03,2.1201063829787237581e+01,250.0,NULL);
INSERT INTO "peak" VALUES(168,4,'slab_displacement','wheelset_1','m',5.02378626148553301608e-04,5.02378626148553301608e-04,3.55780732035531515374e-04,4.37836065467773496127e-04,1.84739698358654258619e-05,4.38225635701286790005e-04,1.14510638297872346241e-02,2.16297872340425563204e+01,250.0,NULL);
INSERT INTO "peak" VALUES(169,4,'slab_acceleration','wheelset_1','m/s^2',1.11178068407787904452e+01,1.05537101246612294855e+01,-1.11178068407787904452e+01,-4.50808356064276771757e-01,3.27705921803492961075e+00,3.30792159707649080502e+00,1.27455319148936183776e-02,2.17196808510638312834e+01,250.0,NULL);
INSERT INTO "peak" VALUES(170,4,'base_displacement','wheelset_1','m',4.7737449003973668124e-04,4.7737449003973668124e-04,3.11129778785236056366e-04,4.00790007913969599431e-04,2.10873492188309970491e-05,4.01344374248296617037e-04,1.12519148936170224062e-02,2.1615957446808511833e+01,250.0,NULL);
INSERT INTO "peak" VALUES(171,4,'base_acceleration','wheelset_1','m/s^2',1.15706795833339306513e+01,1.07076352387788560345e+01,-1.15706795833339306513e+01,-2.3476953234230185652e-01,3.39907091702008079536e+00,3.40716888813101759225e+00,1.2148085106382979989e-02,21.6781914893617,250.0,NULL);
INSERT INTO "peak" VALUES(172,4,'slab_moment','wheelset_1','N m',6.26431543949451406652e+03,6.26431543949451406652e+03,1.97707662477143526306e+03,3.94803196124189389598e+03,8.40071891775597237063e+02,4.03641885219298683293e+03,1.81225531914893621399e-02,2.20930851063829791769e+01,250.0,NULL);
INSERT INTO "peak" VALUES(173,4,'roadbed_pressure','wheelset_1','N/m',3.03752404550513965667e+04,3.03752404550513965667e+04,1.821331709823181518e+04,2.47089843830035097208e+04,1.50429018089751434668e+03,2.47547328442028665459e+04,9.95744680851063865278e-03,2.152606382978723687e+01,250.0,NULL);
INSERT INTO "peak" VALUES(174,4,'pad_force','pads','N',5.32959288166697879194e+04,5.32959288166697879194e+04,2.05993924520065775141e+04,3.45491509440411100517e+04,8.12539147273600065052e+03,35491.7711242951,1.64696170212765974349e-01,32.2718085106383,250.0,NULL);
INSERT INTO "peak" VALUES(175,4,'pad_uplift','pads','N',2.4312153149531527561e+03,2.4312153149531527561e+03,7.34730789378914096211e+02,1.36801729900932014056e+03,4.46925644006507752706e+02,1.43917124125636541973e+03,2.00045106382978732373e-01,3.47265957446808570807e+01,250.0,NULL);
INSERT INTO "peak" VALUES(176,4,'car_body_acceleration','car_body','m/s^2',6.35567929153527250152e-02,5.75950982477471534748e-02,-6.35567929153527250152e-02,9.87631133976768797386e-04,4.21055699227261895356e-02,4.21171513017486107144e-02,8.08544680851063929383e-02,2.6449468085106385474e+01,250.0,NULL);
INSERT INTO "peak" VALUES(177,4,'bogie_acceleration','bogie_1','m/s^2',6.31052209891239890282e+00,5.00777100811819586567e+00,-6.31052209891239890282e+00,-6.74532378319660924637e-02,1.5471784969604385207e+00,1.54864819786508545185e+00,6.67148936170212838309e-03,2.12978723404255347877e+01,250.0,NULL);
INSERT INTO "peak" VALUES(178,4,'bogie_acceleration','bogie_2','m/s^2',7.84208190415022432517e+00,6.46454449409325526687e+00,-7.84208190415022432517e+00,6.9869599230351950303e-02,4.31799748294320728803e+00,4.3185627266025079507e+00,1.85009361702127672621e-01,3.36824468085106403241e+01,250.0,NULL);
INSERT INTO "peak" VALUES(179,4,'wheelset_acceleration','wheelset_1','m/s^2',2.79355835785240884665e+01,2.79355835785240884665e+01,-2.71646441629382273674e+01,-3.17945623627200579797e-01,7.18806984145763205873e+00,7.19509815535941310571e+00,1.06544680851063840176e-02,2.15744680851063854723e+01,250.0,NULL);
INSERT INTO "peak" VALUES(180,4,'wheelset_acceleration','wheelset_2','m/s^2',4.68862185285721935193e+01,4.68862185285721935193e+01,-3.98987785626530140348e+01,-3.6532649343777123807e-01,1.20988766966364220674e+01,1.2104390970520549686e+01,1.06544680851063840176e-02,2.15744680851063854723e+01,250.0,NULL);
INSERT INTO "peak" VALUES(181,4,'wheelset_acceleration','wheelset_3','m/s^2',4.6437954360837210288e+01,4.6437954360837210288e+01,-4.42681457950387837732e+01,-1.39881186146420782856e-01,2.65525509458173587513e+01,2.65529193964894183466e+01,9.90765957446808620545e-02,2.77148936170212785152e+01,250.0,NULL);
INSERT INTO "peak" VALUES(182,4,'wheelset_acceleration','wheelset_4','m/s^2',5.04376688101767243219e+01,5.04376688101767243219e+01,-4.08014793576176231209e+01,-2.74726609668209831305e-01,2.56668824933660033593e+01,2.56683527254539249899e+01,1.88793191489361716906e-01,3.39452127659574500731e+01,250.0,NULL);
INSERT INTO "peak" VALUES(183,4,'wheel_rail_force_20hz','wheelset_1','N',7.57813635170650086361e+04,7.57813635170650086361e+04,67643.204441086,6.90807059087037341653e+04,1.54771444174399812254e+03,6.90980415702065802179e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(184,4,'wheel_unloading','wheelset_1','1',4.86313351754082856537e-01,4.86313351754082856537e-01,-4.93329860609006243254e-01,-6.07064639443452309236e-03,1.27150700216986656254e-01,1.27295535323577901909e-01,1.09531914893617032119e-02,2.15952127659574486537e+01,250.0,NULL);
INSERT INTO "peak" VALUES(185,4,'contact_loss','wheelset_1','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(186,4,'wheel_rail_force_20hz','wheelset_2','N',7.72399766757479083007e+04,7.72399766757479083007e+04,67419.698411772,6.91598667940013547188e+04,1.87339972858087162425e+03,6.91852354300182923905e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(187,4,'wheel_unloading','wheelset_2','1',8.14520642764501756616e-01,8.14520642764501756616e-01,-7.39568060956203754408e-01,-7.30984025850151247077e-03,2.14415476133431842642e-01,2.14540043278943826088e-01,1.08536170212765962356e-02,2.15882978723404264078e+01,250.0,NULL);
INSERT INTO "peak" VALUES(188,4,'contact_loss','wheelset_2','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(189,4,'wheel_rail_force_20hz','wheelset_3','N',6.94731059157300478556e+04,6.94731059157300478556e+04,68534.818205479,6.87544276083757868039e+04,2.18688657211031369344e+02,6.87547754013070662026e+04,0.199348085106383,34.6781914893617,250.0,NULL);
INSERT INTO "peak" VALUES(190,4,'wheel_unloading','wheelset_3','1',0.806192328975708,0.806192328975708,-8.11686208487417126811e-01,-1.62750451535322525863e-03,0.472510226814052,0.472513029677293,9.92757446808510690683e-02,2.77287234042553230048e+01,250.0,NULL);
INSERT INTO "peak" VALUES(191,4,'contact_loss','wheelset_3','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(192,4,'wheel_rail_force_20hz','wheelset_4','N',7.24781765702461707422e+04,7.24781765702461707422e+04,6.81041045448283839484e+04,6.89116671079670777564e+04,8.32842304106447841108e+02,6.89166996445910772298e+04,1.99945531914893642744e-01,3.4719680851063834837e+01,250.0,NULL);
INSERT INTO "peak" VALUES(193,4,'wheel_unloading','wheelset_4','1',8.82799913543384273673e-01,8.82799913543384273673e-01,-7.55145993164821782706e-01,-3.83338198567332796851e-03,4.57232263334505228957e-01,4.57248332365950138633e-01,1.88992340425531923919e-01,3.39590425531914945627e+01,250.0,NULL);
INSERT INTO "peak" VALUES(194,4,'contact_loss','wheelset_4','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(195,4,'car_body_acceleration_comfort','car_body','m/s^2',8.15301253609671677802e-03,1.99381492292189819656e-03,-8.15301253609671677802e-03,-5.09378274980774783248e-03,2.89019941349435635635e-03,0.00585660954409649,5.15795744680851084296e-02,2.44164893617021299125e+01,250.0,NULL);
INSERT INTO "peak" VALUES(196,4,'wheel_rail_force_quantile','wheelset_1','N',1.02493561865621653846e+05,1.02493561865621653846e+05,1.02493561865621653846e+05,1.02493561865621653846e+05,0.0,1.02493561865621653846e+05,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(197,4,'contact_loss_events','wheelset_1','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(198,4,'contact_loss_duration','wheelset_1','s',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(199,4,'wheel_rail_force_quantile','wheelset_2','N',1.19348394894890865542e+05,1.19348394894890865542e+05,1.19348394894890865542e+05,1.19348394894890865542e+05,0.0,1.19348394894890865542e+05,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(200,4,'contact_loss_events','wheelset_2','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(201,4,'contact_loss_duration','wheelset_2','s',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(202,4,'wheel_rail_force_quantile','wheelset_3','N',1.24254679349635611289e+05,1.24254679349635611289e+05,1.24254679349635611289e+05,1.24254679349635611289e+05,0.0,1.24254679349635611289e+05,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(203,4,'contact_loss_events','wheelset_3','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(204,4,'contact_loss_duration','wheelset_3','s',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(205,4,'wheel_rail_force_quantile','wheelset_4','N',1.20398436274039326234e+05,1.20398436274039326234e+05,1.20398436274039326234e+05,1.20398436274039326234e+05,0.0,1.20398436274039326234e+05,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(206,4,'contact_loss_events','wheelset_4','1',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(207,4,'contact_loss_duration','wheelset_4','s',0.0,0.0,0.0,0.0,0.0,0.0,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(208,4,'sperling_index','car_body','1',1.00918504986495283226e+00,1.00918504986495283226e+00,1.00918504986495283226e+00,1.00918504986495283226e+00,0.0,1.00918504986495283226e+00,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(209,4,'wheel_rail_force_20hz_quantile','wheelset_1','N',75776.1397859939,75776.1397859939,75776.1397859939,75776.1397859939,0.0,75776.1397859939,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(210,4,'wheel_rail_force_20hz_quantile','wheelset_2','N',7.72340789350574632391e+04,7.72340789350574632391e+04,7.72340789350574632391e+04,7.72340789350574632391e+04,0.0,7.72340789350574632391e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(211,4,'wheel_rail_force_20hz_quantile','wheelset_3','N',6.94730000358983816122e+04,6.94730000358983816122e+04,6.94730000358983816122e+04,6.94730000358983816122e+04,0.0,6.94730000358983816122e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
INSERT INTO "peak" VALUES(212,4,'wheel_rail_force_20hz_quantile','wheelset_4','N',7.24773929844677186357e+04,7.24773929844677186357e+04,7.24773929844677186357e+04,7.24773929844677186357e+04,0.0,7.24773929844677186357e+04,9.95744680851064e-05,2.08414893617021270691e+01,250.0,NULL);
CREATE TABLE profile (
	id VARCHAR(64) NOT NULL, 
	samples BLOB NOT NULL, 
	points INTEGER NOT NULL, 
	start_m DOUBLE NOT NULL, 
	end_m DOUBLE NOT NULL, 
	wavelength_min_m DOUBLE NOT NULL, 
	wavelength_max_m DOUBLE NOT NULL, 
	lowest_mm DOUBLE NOT NULL, 
	highest_mm DOUBLE NOT NULL, 
	created_at DOUBLE NOT NULL, 
	CONSTRAINT pk_profile PRIMARY KEY (id)
);
INSERT INTO "profile" VALUES('93c53feed5baaec449def0eec1a82e3241a9b1cee8d1e03b8b7eec55edb4a91e',X'0000000000000000000000000000D03F000000000000E03F000000000000E83F000000000000F03F000000000000F43F000000000000F83F000000000000FC3F000000000000004000000000000002400000000000000440000000000000064000000000000008400000000000000A400000000000000C400000000000000E4000000000000010400000000000001140000000000000124000000000000013400000000000001440000000000000154000000000000016400000000000001740000000000000184000000000000019400000000000001A400000000000001B400000000000001C400000000000001D400000000000001E400000000000001F40000000000000204000000000008020400000000000002140000000000080214000000000000022400000000000802240000000000000234000000000008023400000000000002440000000000080244000000000000025400000000000802540000000000000264000000000008026400000000000002740000000000080274000000000000028400000000000802840000000000000294000000000008029400000000000002A400000000000802A400000000000002B400000000000802B400000000000002C400000000000802C400000000000002D400000000000802D400000000000002E400000000000802E400000000000002F400000000000802F400000000000003040000000000040304000000000008030400000000000C030400000000000003140000000000040314000000000008031400000000000C031400000000000003240000000000040324000000000008032400000000000C032400000000000003340000000000040334000000000008033400000000000C033400000000000003440000000000040344000000000008034400000000000C034400000000000003540000000000040354000000000008035400000000000C035400000000000003640000000000040364000000000008036400000000000C036400000000000003740000000000040374000000000008037400000000000C037400000000000003840000000000040384000000000008038400000000000C0384000000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F00000000000000002D431CEBE2361A3F2D431CEBE2362A3F623255302AA9333F2D431CEBE2363A3F',100,0.0,24.75,0.5,24.75,0.0,0.4,1795341455.419);
CREATE TABLE profile_key (
	profile_id VARCHAR(64) NOT NULL, 
	key_id INTEGER NOT NULL, 
	CONSTRAINT pk_profile_key PRIMARY KEY (profile_id, key_id), 
	CONSTRAINT fk_profile_key_key_id_api_key FOREIGN KEY(key_id) REFERENCES api_key (id), 
	CONSTRAINT fk_profile_key_profile_id_profile FOREIGN KEY(profile_id) REFERENCES profile (id) ON DELETE CASCADE
);
CREATE TABLE "study" (
	id VARCHAR(32) NOT NULL, 
	name VARCHAR NOT NULL, 
	labels JSON NOT NULL, 
	priority INTEGER NOT NULL, 
	keep_history BOOLEAN NOT NULL, 
	request JSON NOT NULL, 
	cases_reused INTEGER NOT NULL, 
	created_at DOUBLE NOT NULL, 
	started_at DOUBLE, 
	finished_at DOUBLE, 
	cancel_requested_at DOUBLE, 
	owner_id INTEGER, 
	end_turn INTEGER DEFAULT '0' NOT NULL, 
	CONSTRAINT pk_study PRIMARY KEY (id), 
	CONSTRAINT fk_study_owner_id_api_key FOREIGN KEY(owner_id) REFERENCES api_key (id)
);
INSERT INTO "study" VALUES('c80f9d894bc54ec981c99e1f2b70540a','Both slabs','{"line": "test"}',0,1,'{"track": {"pad_stiffness_n_per_m": 50000000.0}, "numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "Both slabs", "labels": {"line": "test"}, "sweep": {"speed_kmh": [300.0], "slab": ["continuous", "discontinuous"], "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}, "kind": "product"}, "keep_history": true}',0,1795341361.858,1795341453.071,1795341454.677,NULL,NULL,2);
INSERT INTO "study" VALUES('08342e0a94b44a5f8534174c2a897c43','A spectrum','{}',0,0,'{"numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "A spectrum", "sweep": {"speed_kmh": [250.0], "irregularity": {"kind": "spectrum", "percentile": [25.0], "wavelength_band_m": [{"min": 2.0, "max": 30.0}], "seed": 7}, "kind": "product"}}',0,1795341454.719,1795341454.746,1795341455.299,NULL,NULL,3);
INSERT INTO "study" VALUES('96013dd5634143eab8ffd06dc38166b8','A measured profile','{}',0,0,'{"numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "A measured profile", "sweep": {"speed_kmh": [250.0], "irregularity": {"kind": "measured", "profile_id": "93c53feed5baaec449def0eec1a82e3241a9b1cee8d1e03b8b7eec55edb4a91e"}, "kind": "product"}}',0,1795341455.443,1795341455.491,1795341455.949,NULL,NULL,4);
INSERT INTO "study" VALUES('5d1e64668089479ebc1cf6c1a6249c0f','Queued when the release ended','{}',0,0,'{"numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "Queued when the release ended", "sweep": {"speed_kmh": [200.0], "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}, "kind": "product"}}',0,1795341473.498,NULL,NULL,NULL,NULL,5);
CREATE TABLE study_case (
	study_id VARCHAR(32) NOT NULL, 
	case_id INTEGER NOT NULL, 
	position INTEGER NOT NULL, 
	CONSTRAINT pk_study_case PRIMARY KEY (study_id, case_id), 
	CONSTRAINT fk_study_case_case_id_case FOREIGN KEY(case_id) REFERENCES "case" (id), 
	CONSTRAINT fk_study_case_study_id_study FOREIGN KEY(study_id) REFERENCES study (id) ON DELETE CASCADE
);
INSERT INTO "study_case" VALUES('c80f9d894bc54ec981c99e1f2b70540a',1,0);
INSERT INTO "study_case" VALUES('c80f9d894bc54ec981c99e1f2b70540a',2,1);
INSERT INTO "study_case" VALUES('08342e0a94b44a5f8534174c2a897c43',3,0);
INSERT INTO "study_case" VALUES('96013dd5634143eab8ffd06dc38166b8',4,0);
INSERT INTO "study_case" VALUES('5d1e64668089479ebc1cf6c1a6249c0f',5,0);
CREATE TABLE study_profile (
	study_id VARCHAR(32) NOT NULL, 
	profile_id VARCHAR(64) NOT NULL, 
	CONSTRAINT pk_study_profile PRIMARY KEY (study_id, profile_id), 
	CONSTRAINT fk_study_profile_profile_id_profile FOREIGN KEY(profile_id) REFERENCES profile (id), 
	CONSTRAINT fk_study_profile_study_id_study FOREIGN KEY(study_id) REFERENCES study (id) ON DELETE CASCADE
);
INSERT INTO "study_profile" VALUES('96013dd5634143eab8ffd06dc38166b8','93c53feed5baaec449def0eec1a82e3241a9b1cee8d1e03b8b7eec55edb4a91e');
CREATE TABLE study_share (
	study_id VARCHAR(32) NOT NULL, 
	key_id INTEGER NOT NULL, 
	CONSTRAINT pk_study_share PRIMARY KEY (study_id, key_id), 
	CONSTRAINT fk_study_share_key_id_api_key FOREIGN KEY(key_id) REFERENCES api_key (id), 
	CONSTRAINT fk_study_share_study_id_study FOREIGN KEY(study_id) REFERENCES study (id) ON DELETE CASCADE
);
INSERT INTO "study_share" VALUES('96013dd5634143eab8ffd06dc38166b8',1);
CREATE TABLE verification (
	id INTEGER NOT NULL, 
	case_id INTEGER NOT NULL, 
	state VARCHAR(16) NOT NULL, 
	attempt INTEGER NOT NULL, 
	lease_token VARCHAR(32), 
	lease_expires DOUBLE, 
	requested_at DOUBLE NOT NULL, 
	finished_at DOUBLE, 
	solver_version VARCHAR, 
	outcome VARCHAR(16), 
	differences JSON, 
	error JSON, 
	CONSTRAINT pk_verification PRIMARY KEY (id), 
	CONSTRAINT fk_verification_case_id_case FOREIGN KEY(case_id) REFERENCES "case" (id) ON DELETE CASCADE
);
CREATE TABLE worker (
	name VARCHAR NOT NULL, 
	expires DOUBLE NOT NULL, 
	CONSTRAINT pk_worker PRIMARY KEY (name)
);
INSERT INTO "worker" VALUES('host:26960',1795341461.349);
CREATE INDEX ix_idempotency_key_created_at ON idempotency_key (created_at);
CREATE INDEX ix_event_study_id_id ON event (study_id, id);
CREATE INDEX ix_study_case_case_id ON study_case (case_id);
CREATE INDEX ix_case_operator ON "case" (operator_key, state, priority, id);
CREATE INDEX ix_case_queue ON "case" (state, priority DESC, turn, id);
CREATE INDEX ix_verification_case_id_id ON verification (case_id, id);
CREATE INDEX ix_verification_state_id ON verification (state, id);
CREATE INDEX ix_peak_quantity_id ON peak (quantity, id);
CREATE INDEX ix_peak_position_id ON peak (position, id);
CREATE INDEX ix_peak_unit_id ON peak (unit, id);
CREATE INDEX ix_peak_peak_id ON peak (peak, id);
CREATE INDEX ix_peak_by_peak ON peak (quantity, peak, id, speed_kmh, percentile);
CREATE INDEX ix_peak_by_maximum ON peak (quantity, maximum, id, speed_kmh, percentile);
CREATE INDEX ix_peak_by_minimum ON peak (quantity, minimum, id, speed_kmh, percentile);
CREATE INDEX ix_peak_by_mean ON peak (quantity, mean, id, speed_kmh, percentile);
CREATE INDEX ix_peak_by_std ON peak (quantity, std, id, speed_kmh, percentile);
CREATE INDEX ix_peak_by_rms ON peak (quantity, rms, id, speed_kmh, percentile);
CREATE INDEX ix_peak_by_time_s ON peak (quantity, time_s, id, speed_kmh, percentile);
CREATE INDEX ix_peak_by_track_position_m ON peak (quantity, track_position_m, id, speed_kmh, percentile);
CREATE INDEX ix_case_speed_kmh_id ON "case" (speed_kmh, id);
CREATE INDEX ix_case_slab_id ON "case" (slab, id);
CREATE INDEX ix_case_irregularity_id ON "case" (irregularity, id);
CREATE INDEX ix_case_spectrum_id ON "case" (spectrum, id);
CREATE INDEX ix_case_percentile_id ON "case" (percentile, id);
CREATE INDEX ix_case_wavelength_min_m_id ON "case" (wavelength_min_m, id);
CREATE INDEX ix_case_wavelength_max_m_id ON "case" (wavelength_max_m, id);
CREATE INDEX ix_case_seed_id ON "case" (seed, id);
CREATE INDEX ix_case_realisation_id ON "case" (realisation, id);
CREATE INDEX ix_case_wavelength_m_id ON "case" (wavelength_m, id);
CREATE INDEX ix_case_amplitude_mm_id ON "case" (amplitude_mm, id);
CREATE INDEX ix_case_solver_version_id ON "case" (solver_version, id);
CREATE INDEX ix_profile_created_at ON profile (created_at);
CREATE INDEX ix_study_profile_profile_id ON study_profile (profile_id);
CREATE INDEX ix_study_created_at ON study (created_at);
CREATE INDEX ix_study_owner_id ON study (owner_id);
CREATE INDEX ix_study_share_key_id ON study_share (key_id);
CREATE INDEX ix_profile_key_key_id ON profile_key (key_id);
CREATE INDEX ix_case_charged ON "case" (charged_to, finished_at);
COMMIT;